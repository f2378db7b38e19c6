// SPDX-License-Identifier: GPL-3.0-or-later
// The ground under a plane of constant depth as the page's columns see it.
#pragma once

#include "geometry/homography.hpp"
#include "profiles/cut_surface.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <vector>

#include "tone/page_columns.hpp"

namespace orograph {

/// One profile, a value a column.
struct SampledProfile {
  double depth_m = 0;
  int level = 0; ///< how often the number of lines is halved before this one goes; below 0: added
  int halvings = 0; ///< of the planned step, of what is between it and the one in front of it
  std::vector<double> z_m; ///< NaN where no ground is
  std::vector<std::uint8_t> is_level;
  std::vector<float> x_mm, y_mm; ///< on the page
};

/// Cuts and samples. Safe from several threads.
class ProfileSampler {
public:
  /// REQUIRES that all outlive it.
  ProfileSampler(const SurfaceCutter& cutter, const View& view, const Homography& to_page,
                 const PageColumns& columns)
      : cutter_(cutter), view_(view), to_page_(to_page), columns_(columns) {}

  /// Fills all but level and halvings in.
  void sample(double depth_m, SampledProfile& out) const;

private:
  const SurfaceCutter& cutter_;
  const View& view_;
  const Homography& to_page_;
  const PageColumns& columns_;
};

} // namespace orograph
