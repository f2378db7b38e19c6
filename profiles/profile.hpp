// SPDX-License-Identifier: GPL-3.0-or-later
// One profile: the terrain cut by a vertical plane of constant depth; and its picture in the
// visibility plane.
#pragma once

#include "geometry/segment.hpp"
#include "view/view.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace orograph {

/// What lies between a profile's vertex and the next one.
enum class Span : std::uint8_t {
  gap,   ///< no terrain
  slope, ///< terrain
  level, ///< terrain that belongs to level ground (a sea, a lake)
  wall   ///< straight up or down a vertical triangle that the eye sees
};

/// A part of a profile.
struct URange {
  double low_m = -std::numeric_limits<double>::infinity();
  double high_m = std::numeric_limits<double>::infinity();
};

constexpr std::array<URange, 1> kAllOfProfile{};

/// Vertices from left to right in the profile frame. `after[i]` tells what is between vertex i and
/// i + 1; the last is a gap.
struct Profile {
  double depth_m = 0;
  std::vector<double> u_m; ///< never falling
  std::vector<double> z_m; ///< exaggerated
  std::vector<Span> after;
  /// Of a grid on the earth: the triangle of each span that is none of the gaps.
  std::vector<std::uint32_t> triangles;

  std::size_t size() const { return u_m.size(); }
  /// What is beyond the size so far is left to be filled.
  void resize(std::size_t count) {
    u_m.resize(count);
    z_m.resize(count);
    after.resize(count);
  }
  void clear() {
    u_m.clear();
    z_m.clear();
    after.clear();
    triangles.clear();
  }
};

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
