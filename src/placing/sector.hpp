// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a view that have a visibility plane of their own.
#pragma once

#include "geometry/box.hpp"
#include "geometry/homography.hpp"
#include "geometry/turn.hpp"
#include "horizon/clip_profile.hpp"
#include "horizon/compare.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <optional>
#include <vector>

#include "tone/tone.hpp"

namespace orograph {

/// A depth to cut at, in its sector, and the profile's number in the drawing.
struct PlannedProfile {
  double depth_m;
  std::int32_t number;
  std::optional<std::vector<ToneRun>> runs = {}; ///< none: all of it is drawn, with the layer's pen
  int level = 0;                                 ///< as in TonedProfile
  std::vector<float> darkness = {};              ///< as in TonedProfile, in the sector's columns
};

/// What is ahead of the eye, or, where the page shows any of that, behind it; or one of a
/// panorama's.
struct Sector {
  View view;
  Turn to_view;                         ///< from its profile frame to that of the whole view
  Homography to_page;                   ///< its visibility plane to page mm; of a panorama nearly
  std::vector<PlannedProfile> profiles; ///< front to back
  double nearest_m = 0, farthest_m = 0; ///< depths between which there is terrain
  bool behind = false;
  std::optional<Box2> frame_mm; ///< of a panorama's: its profiles' strokes end here
  double azimuth =
      0; ///< of a panorama's: of its forward direction, from the page's middle; radians
  PageColumns columns;      ///< of its profiles' darkness
  bool keeps_strip = false; ///< has a sector behind it, and what lies between the two
};

/// What the page shows of a sector's visibility plane; without ends where it shows rays beside the
/// eye.
XRange page_range(const Sector& sector);

/// The visibility tolerance from the page to the visibility plane: `mm` as differences of Y, for
/// what the page shows of a sector.
TieTolerance tie_tolerance(const Sector& sector, double mm);

} // namespace orograph
