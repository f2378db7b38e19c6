// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles whose lines are even on the page, and carry light: which planes are cut, and where along
// each of them a line is drawn, how wide.
#pragma once

#include "geometry/box.hpp"
#include "geometry/homography.hpp"
#include "geometry/segment.hpp"
#include "profiles/cut_surface.hpp"
#include "view/view.hpp"

#include <span>
#include <vector>

#include "tone/page_columns.hpp"
#include "tone/sampled_profile.hpp"
#include "tone/tone_request.hpp"

namespace orograph {

/// Part of a profile that is drawn, where it is visible.
struct ToneRun {
  double x_begin, x_end; ///< X, in the visibility plane
  double width_mm;       ///< of its line; 0: the layer's pen
};

struct TonedProfile {
  double depth_m;
  int level; ///< how often the number of lines is halved before this one goes; below 0: added
  std::vector<ToneRun> runs; ///< left to right; those of one line touch
  /// In the page's columns, how dark the ground should be: a share of black, haze taken off; NaN
  /// where nothing is seen. Empty without light, and where lines show it.
  std::vector<float> darkness;
};

/// The page in which lines are to be even.
struct TonePage {
  const View& view;
  const Homography& to_page;
  XRange range; ///< what of X is shown, or of u; finite
  Box2 frame_mm;
  bool of_u = false; ///< where rays beside the eye are shown
};

/// The columns of a page in which its ground is looked at, half a millimetre wide.
PageColumns columns_of(const TonePage& page);

/// Profiles for those planned, front to back; those of which nothing would be drawn are left out,
/// unless the request keeps those planned.
///
/// The ground is sampled in `columns_of` the page, under each planned profile
/// and under as many more as are needed (`plan_on_page`). With s the distance on the page, across
/// the lines, of planned profiles on the ground around a place, and d the spacing that is asked
/// for, a line of level L is drawn where L >= log2(d / s), rounded; so lines are between d /
/// sqrt(2) and d sqrt(2) apart. Breaks of less than 1.5 mm are bridged, lines of less than 2 mm
/// left out. With light, a line has the width that makes the ground as dark as it should be;
/// towards its end the line that goes gets thinner and those that stay get wider.
std::vector<TonedProfile> toned_profiles(const SurfaceCutter& cutter, const TonePage& page,
                                         std::span<const double> depths_m, double nearest_m,
                                         const ToneRequest& request);

/// The same of a panorama, whose profiles' runs are between columns, by number. `view` is any of
/// its sectors'.
std::vector<TonedProfile> toned_profiles(const ProfileSampler& sampler, const PageColumns& columns,
                                         const View& view, const Box2& frame_mm,
                                         std::span<const double> depths_m, double nearest_m,
                                         const ToneRequest& request);

} // namespace orograph
