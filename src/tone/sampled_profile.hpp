// SPDX-License-Identifier: GPL-3.0-or-later
// The ground under a plane of constant depth as the page's columns see it.
#pragma once

#include "geometry/homography.hpp"
#include "geometry/panorama_page.hpp"
#include "profiles/cut_surface.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "tone/page_columns.hpp"

namespace orograph {

/// How a line goes on the page about one place: from a column on its left to one on its right.
struct WayOnPage {
  float x_mm = 0, y_mm = 0, length_mm = 0;
};

/// One profile, a value a column.
struct SampledProfile {
  double depth_m = 0;
  int level = 0; ///< how often the number of lines is halved before this one goes; below 0: added
  int halvings = 0; ///< of the planned step, of what is between it and the one in front of it
  std::vector<double> z_m; ///< NaN where no ground is
  std::vector<std::uint8_t> is_level;
  std::vector<float> x_mm, y_mm; ///< on the page
  std::vector<WayOnPage> way;    ///< as ways_on_page has them
};

/// The way of each column of which the rest is known: between two columns on either side of it, or
/// as many as have ground all the way; of no length where there is none on either side.
void find_ways_on_page(SampledProfile& profile);

/// What columns, one behind the other, see in one visibility plane.
struct SampledSector {
  const SurfaceCutter& cutter;
  const View& view;
  const Homography& to_page;
  PageColumns columns;
};

/// Cuts and samples. Safe from several threads.
class ProfileSampler {
public:
  /// REQUIRES that all outlive it.
  ProfileSampler(const SurfaceCutter& cutter, const View& view, const Homography& to_page,
                 const PageColumns& columns)
      : sectors_{{cutter, view, to_page, columns}} {}
  /// Of a panorama, left to right.
  ProfileSampler(std::vector<SampledSector> sectors, const PanoramaPage& page)
      : sectors_(std::move(sectors)), page_(page) {}

  /// Fills all but level and halvings in.
  void sample(double depth_m, SampledProfile& out) const;

private:
  void sample(double depth_m, const SampledSector& sector, std::size_t first,
              SampledProfile& out) const;

  std::vector<SampledSector> sectors_;
  std::optional<PanoramaPage> page_;
};

} // namespace orograph
