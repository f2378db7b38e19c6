// SPDX-License-Identifier: GPL-3.0-or-later
// What a void's near rim hides of the walls on its far side.
#pragma once

#include "geometry/profile_point.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// An edge of a void's outline, the ends by their places among points.
struct VoidRim {
  std::uint32_t from, to;
  bool is_towards_eye; ///< the wall below it is turned to the eye
};

/// For each of the rims the Y below which nothing of the wall under it is seen by less than
/// `slack_y`; -infinity where that isn't known. A ray that meets a void's far wall has passed its
/// near rim: the lowest of that at about the wall's X hides what is lower. REQUIRES all rims of
/// each void, and a view in which all ground ahead of the near plane is looked at. Cost O(rims).
std::vector<double> hidden_below(const View& view, std::span<const ProfilePoint> points,
                                 std::span<const VoidRim> rims, double slack_y);

} // namespace orograph
