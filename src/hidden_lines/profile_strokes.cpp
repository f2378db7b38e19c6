// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/profile_strokes.hpp"

#include <algorithm>

namespace orograph {
namespace {

// As `project_homogeneous`, of a profile of a sector of the view.
PointsAtDepth points_at_depth(const View& view, const Sector& sector, double depth_m) {
  const double sign = sector.behind ? -1 : 1, v = sign * depth_m;
  if (view.is_perspective()) return {sign, v, 0, 1, -view.eye_z_m, v};
  return {sign, v, v * view.x_per_v, view.y_per_z, v * view.y_per_v, 1};
}

} // namespace

void ProfileStrokes::add(const Profile& profile, std::int32_t number,
                         std::span<const VisibleRun> visible) {
  const PointsAtDepth depth = points_at_depth(view_, sector_, profile.depth_m);
  const std::span<const double> u_m = profile.u_m, z_m = profile.z_m;
  const auto at = [&](std::uint32_t left, double t) {
    const ProfilePoint p =
        point_between({u_m[left], 0, z_m[left]}, {u_m[left + 1], 0, z_m[left + 1]}, t);
    return depth.at(p.u, p.z);
  };
  bool open = false;
  std::uint32_t open_vertex = 0; // where the open stroke ends, if it ends at a vertex
  bool at_vertex = false;
  const auto close = [&] {
    if (open) builder_.end();
    open = false;
  };
  // Of spans that are all drawn, the first from t_begin and the last to t_end.
  const auto draw = [&](std::uint32_t first, std::uint32_t last, double t_begin, double t_end) {
    if (!(open && at_vertex && t_begin <= 0 && open_vertex == first)) {
      close();
      builder_.begin(number, depth.v);
      builder_.add(at(first, t_begin));
      open = true;
    }
    at_vertex = t_end >= 1;
    open_vertex = last + 1;
    const std::uint32_t vertices = (at_vertex ? last + 1 : last) - first;
    builder_.add(depth, u_m.subspan(first + 1, vertices), z_m.subspan(first + 1, vertices));
    if (!at_vertex) builder_.add(at(last, t_end));
  };
  for (const VisibleRun& run : visible) {
    const auto end = profile.after.begin() + run.last + 1;
    for (auto span = profile.after.begin() + run.first; span != end;) {
      // All that is drawn up to the next level ground, which isn't.
      const auto level = draws_level_ ? end : std::find(span, end, Span::level);
      if (span != level) {
        const auto first = static_cast<std::uint32_t>(span - profile.after.begin()),
                   last = static_cast<std::uint32_t>(level - profile.after.begin()) - 1;
        draw(first, last, first == run.first ? run.t_begin : 0, last == run.last ? run.t_end : 1);
      }
      if (level == end) break;
      close();
      span = level + 1;
    }
  }
  close();
}

} // namespace orograph
