// SPDX-License-Identifier: GPL-3.0-or-later
// With elevation and roll 0 the picture is the visibility plane: X = u / v, Y = (z - eye) / v.
#include "placing/frame_eye_view.hpp"

#include "geometry/blocked_points.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace orograph {
namespace {

// Between the window's sides, in front of the eye.
struct Wedge {
  const View& view;

  // Of each of its three planes, 0 or more inside.
  std::array<double, 3> inside(ProfilePoint p) const {
    return {p.u - view.window.low.x * p.v, view.window.high.x * p.v - p.u, p.v - view.near_m};
  }
  bool holds(ProfilePoint p) const {
    const auto by = inside(p);
    return by[0] >= 0 && by[1] >= 0 && by[2] >= 0;
  }
  double y(ProfilePoint p) const { return (p.z - view.eye_z_m) / p.v; }

  double y_of(Vec3 ground) const {
    const ProfilePoint p = to_profile_frame(view, ground);
    return holds(p) ? y(p) : -kInfinity;
  }

  // No less than Y anywhere in a box. Its ground sinks by a quadratic form, between 0 and the
  // values at the corners.
  double bound(const Box3& box) const {
    std::array<double, 3> most_inside{-kInfinity, -kInfinity, -kInfinity};
    double nearest = kInfinity, farthest = -kInfinity, least_drop = 0;
    for (int i = 0; i < 8; ++i) {
      const ProfilePoint p = to_profile_frame(view, corner_of(box, i));
      const auto by = inside(p);
      for (std::size_t side = 0; side < by.size(); ++side)
        most_inside[side] = std::max(most_inside[side], by[side]);
      nearest = std::min(nearest, p.v);
      farthest = std::max(farthest, p.v);
      least_drop = std::min(least_drop, view.drop.at(p.u, p.v));
    }
    if (std::ranges::any_of(most_inside, [](double most) { return most < 0; })) return -kInfinity;
    const double above_m = box.high.z * view.exaggeration - least_drop - view.eye_z_m;
    return above_m / (above_m > 0 ? std::max(nearest, view.near_m) : farthest);
  }

  double greatest_y(const BlockedPoints& points) const {
    return greatest(
               points, [&](Vec3 p) { return y_of(p); },
               [&](const Box3& box, double) { return bound(box); }, {})
        .value;
  }
};

// The part of an edge in the wedge, as shares of its way; none where it is outside.
std::optional<std::array<double, 2>> part_in(const Wedge& wedge, ProfilePoint a, ProfilePoint b) {
  std::array<double, 2> part{0, 1};
  const auto at_a = wedge.inside(a), at_b = wedge.inside(b);
  for (std::size_t side = 0; side < at_a.size(); ++side) {
    if (at_a[side] >= 0 && at_b[side] >= 0) continue;
    if (at_a[side] < 0 && at_b[side] < 0) return std::nullopt;
    const double crossing = at_a[side] / (at_a[side] - at_b[side]);
    if (at_a[side] < 0)
      part[0] = std::max(part[0], crossing);
    else
      part[1] = std::min(part[1], crossing);
  }
  return part[0] <= part[1] ? std::optional(part) : std::nullopt;
}

// The lowest that can be seen: nothing visible is lower than where sight comes in over the
// terrain's edge. Infinite where no such edge is in the wedge.
double lowest_near_edge(const Wedge& wedge, const TerrainShape& terrain) {
  double lowest = kInfinity;
  for (const OutlineEdge& edge : terrain.outline) {
    const ProfilePoint a = to_profile_frame(wedge.view, edge.from),
                       b = to_profile_frame(wedge.view, edge.to);
    // The terrain is on the left of a -> b; sight comes in where it crosses from right to left.
    if (a.v * b.u - a.u * b.v < 0) continue;
    const auto part = part_in(wedge, a, b);
    if (!part) continue;
    for (const double t : *part) {
      const ProfilePoint p{(1 - t) * a.u + t * b.u, (1 - t) * a.v + t * b.v,
                           (1 - t) * a.z + t * b.z};
      lowest = std::min(lowest, wedge.y(p));
    }
  }
  return lowest;
}

// Y between which the window may lie, lest it shows what is beside the eye: a hair less than what
// `shows_beside` goes by.
double steepest_y(const View& view) {
  const double x = std::max(std::abs(view.window.low.x), std::abs(view.window.high.x));
  return 0.999 * greatest_y_ahead(x);
}

} // namespace

bool is_framed_by_skyline(const ViewSpec& view) {
  return view.has_eye() && !view.file && !view.pitch && !view.look_at_map && !view.look_at_lonlat &&
         view.roll == Angle();
}

bool frame_eye_view(View& view, const TerrainShape& terrain, const std::vector<GroundAhead>& ahead,
                    bool stands_over_ground, const WindowShape& shape) {
  const Wedge wedge{view};
  double highest = wedge.greatest_y(terrain.points), lowest_skyline = kInfinity;
  for (const GroundAhead& column : ahead) {
    const auto at = column.skyline(view);
    if (at < 0) continue;
    const double y = column.y(view, static_cast<std::size_t>(at));
    highest = std::max(highest, y);
    lowest_skyline = std::min(lowest_skyline, y);
  }
  constexpr double kOverLandscape = -1; // 45 degrees down
  if (!(highest > kOverLandscape)) return false;

  const double width = view.window.width(), most = shape.greatest_aspect * width;
  if (const double solids = wedge.greatest_y(terrain.beside); solids <= highest + 0.5 * most)
    highest = std::max(highest, solids);
  const double lowest = stands_over_ground ? -kInfinity : lowest_near_edge(wedge, terrain);
  double height = most;
  if (shape.ends_with_picture) {
    const double foreground =
        std::max(std::min(lowest_skyline, highest) - kForegroundShare * width, lowest);
    height = std::min(most, (highest - foreground) / (1 - kSkyShare));
  }
  double top = highest + kSkyShare * height;
  if (!shape.ends_with_picture && lowest > top - height)
    top = 0.5 * (highest + lowest) + 0.5 * height;

  const double steepest = steepest_y(view);
  if (!(height > 0 && height <= 2 * steepest)) return false;
  top = std::clamp(top, height - steepest, steepest);
  view.window.low.y = top - height;
  view.window.high.y = top;
  return true;
}

} // namespace orograph
