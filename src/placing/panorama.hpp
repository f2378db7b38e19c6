// SPDX-License-Identifier: GPL-3.0-or-later
// Panoramas: all that is about an eye, in sectors that are fixed to north (docs/panoramas.md).
#pragma once

#include "draw/page.hpp"
#include "geometry/panorama_page.hpp"
#include "placing/ground_ahead.hpp"
#include "placing/map_spec.hpp"
#include "placing/sector.hpp"
#include "view/place_view.hpp"

#include <optional>
#include <vector>

namespace orograph {

/// What of the whole picture goes into one strip: up to `end_mm` of its width, moved by `shift_mm`.
struct PanoramaStrip {
  double end_mm;
  Vec2 shift_mm;
};

/// Angles are in the ground frame.
struct Panorama {
  PanoramaKind kind = PanoramaKind::cylindrical;
  double middle_deg = 0, width_deg = 360;    ///< azimuths
  double low_tangent = -1, high_tangent = 1; ///< of altitudes
  EarthDrop drop;                            ///< of the view's ground
  PanoramaPage page; ///< of all of it in one strip; the frame's forward is in the middle
  Box2 frame_mm;     ///< on that page
  std::vector<PanoramaStrip> strips; ///< left to right, where there are several

  double whole_sector_mm() const; ///< how wide a sector is that the page shows all of
  double altitude_deg(double tangent) const;
  /// Where on the page each strip is; one at least.
  std::vector<Box2> strip_boxes_mm() const;
  /// Around all of them.
  Box2 strips_mm() const;
};

/// Where a panorama has no range, it has its middle: the view with the direction to that, if it
/// says anything of it. All of it goes from north to north.
ViewSpec looking_to_middle(ViewSpec view);

/// Which azimuths are asked for: middle and width, in the frame of a request that has met its
/// terrain and looks to the middle.
Panorama panorama_asked(const ViewSpec& view, const ViewRequest& request);

/// The sectors, left to right, without profiles: each a level perspective view of its own, and of
/// those at the page's ends no more than is on it. `ahead` looks to the middle. REQUIRES a range of
/// altitudes and a page.
std::vector<Sector> sectors_of(const Panorama& panorama, const View& ahead);

/// Half the width in X of a sector that the page shows all of.
double whole_sector_half_width();

/// In all directions that are shown, some degrees apart.
std::vector<GroundAhead> ground_about(const Panorama& panorama, const View& ahead,
                                      const CutSurface& of);

/// Chooses altitudes by what is seen, where none are asked for: the highest skyline, and a little
/// sky above it; below, 25 degrees under the lowest skyline, or as the ground ends, or as much as
/// the page has room for. Where it hasn't room for all of the skyline, as where a rock beside the
/// eye rises far above it, most of it is in the upper three quarters. Throws Error where there is
/// no ground in those directions.
void frame_panorama(Panorama& panorama, const View& ahead, const TerrainShape& terrain,
                    const std::vector<GroundAhead>& about, bool stands_over_ground,
                    const std::optional<AltitudeRange>& asked, const PageRequest& page);

/// Lays it out; the picture is as large as fits, in its strips. Throws Errors as `place_on_page`.
Page place_panorama_on_page(Panorama& panorama, const View& ahead, const PageRequest& request);

} // namespace orograph
