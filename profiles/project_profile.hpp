// SPDX-License-Identifier: GPL-3.0-or-later
// From a profile to source segments in the visibility plane.
#pragma once

#include "geometry/projected_profile.hpp"
#include "geometry/segment.hpp"
#include "profiles/profile.hpp"
#include "view/view.hpp"

#include <vector>

namespace orograph {

/// The profile's spans as segments, left to right, into `out`; those along walls, which stand
/// upright (x0 == x1), into `uprights`. A segment's id is `number` in the upper 32 bits and the
/// index of its left vertex in the lower. Spans that are gaps, and others that have no extent in X
/// after rounding, have no segment. REQUIRES profile.depth_m > 0 in perspective.
void project_profile(const Profile& profile, std::uint32_t number, const View& view,
                     std::vector<Segment>& out, std::vector<Segment>& uprights);

/// The same as vertices, all of them, and the runs between gaps and walls; and those along walls.
void project_profile(const Profile& profile, std::uint32_t number, const View& view,
                     ProjectedProfile& out, std::vector<Segment>& uprights);

/// The part of a profile whose picture is in a range of X.
inline URange u_range(const View& view, double depth_m, XRange range) {
  if (view.is_perspective()) return {range.begin * depth_m, range.end * depth_m};
  return {range.begin - depth_m * view.x_per_v, range.end - depth_m * view.x_per_v};
}

inline std::uint32_t left_vertex(const Segment& segment) {
  return static_cast<std::uint32_t>(segment.id);
}

} // namespace orograph
