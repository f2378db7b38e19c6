// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/profile_strokes.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace orograph {
namespace {

// As `project_homogeneous`, of a profile of a sector of the view.
PointsAtDepth points_at_depth(const View& view, const Sector& sector, double depth_m) {
  const double sign = sector.behind ? -1 : 1, v = sign * depth_m;
  if (sector.frame_mm) return {1, depth_m, 0, 1, 0, 1, sector.to_view};
  if (view.is_perspective()) return {sign, v, 0, 1, -view.eye_z_m, v};
  return {sign, v, v * view.x_per_v, view.y_per_z, v * view.y_per_v, 1};
}

// A visible run, or what is drawn of it with one pen.
struct DrawnRun {
  VisibleRun run;
  double width_mm; ///< 0: the layer's
  bool goes_on;    ///< from the end of the one in front of it
};

double u_at(const Profile& profile, std::uint32_t left, double t) {
  const double u = profile.u_m[left];
  return t >= 1 ? profile.u_m[left + 1] : u + t * (profile.u_m[left + 1] - u);
}

// What of a visible run is between two places along u; empty where t_end isn't behind t_begin.
VisibleRun part_between(const Profile& profile, const VisibleRun& run, double begin_m,
                        double end_m) {
  VisibleRun part = run;
  const auto first = profile.u_m.begin();
  const auto left_of = [&](double u) { // the span with u in it
    const auto right = std::upper_bound(first + run.first + 1, first + run.last + 1, u);
    return static_cast<std::uint32_t>(right - first) - 1;
  };
  const auto share = [&](std::uint32_t left, double u) {
    const double width = profile.u_m[left + 1] - profile.u_m[left];
    return width > 0 ? std::clamp((u - profile.u_m[left]) / width, 0.0, 1.0) : 0;
  };
  if (begin_m > u_at(profile, run.first, run.t_begin)) {
    part.first = left_of(begin_m);
    part.t_begin = share(part.first, begin_m);
  }
  if (end_m < u_at(profile, run.last, run.t_end)) {
    part.last = left_of(end_m);
    part.t_end = share(part.last, end_m);
  }
  return part;
}

// Of runs in order along the profile, what its tone draws.
void drawn_runs(const Profile& profile, const PlannedProfile& planned, const View& view,
                std::span<const VisibleRun> visible, std::vector<DrawnRun>& out) {
  out.clear();
  if (!planned.runs) {
    for (const VisibleRun& run : visible) out.push_back({run, 0, false});
    return;
  }
  auto tone = planned.runs->begin();
  for (const VisibleRun& run : visible) {
    const double begin_m = u_at(profile, run.first, run.t_begin),
                 end_m = u_at(profile, run.last, run.t_end);
    const auto ends = [&](const ToneRun& of) {
      return u_range(view, profile.depth_m, {of.x_begin, of.x_end});
    };
    while (tone != planned.runs->end() && ends(*tone).high_m <= begin_m) ++tone;
    bool is_first = true;
    for (auto next = tone; next != planned.runs->end() && ends(*next).low_m < end_m; ++next) {
      const URange range = ends(*next);
      const VisibleRun part = part_between(profile, run, range.low_m, range.high_m);
      if (std::pair(part.first, part.t_begin) < std::pair(part.last, part.t_end))
        out.push_back({part, next->width_mm, !is_first && std::prev(next)->x_end == next->x_begin});
      is_first = false;
    }
  }
}

} // namespace

void ProfileStrokes::add(const Profile& profile, const PlannedProfile& planned,
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
  const auto draw = [&](const DrawnRun& drawn, std::uint32_t first, std::uint32_t last,
                        double t_begin, double t_end) {
    const bool goes_on =
        open && ((at_vertex && t_begin <= 0 && open_vertex == first) ||
                 (drawn.goes_on && first == drawn.run.first && t_begin == drawn.run.t_begin));
    if (!goes_on) {
      close();
      builder_.begin(planned.number, depth.v);
      builder_.add(at(first, t_begin));
      open = true;
    }
    builder_.widen(drawn.width_mm);
    at_vertex = t_end >= 1;
    open_vertex = last + 1;
    const std::uint32_t vertices = (at_vertex ? last + 1 : last) - first;
    builder_.add(depth, u_m.subspan(first + 1, vertices), z_m.subspan(first + 1, vertices));
    if (!at_vertex) builder_.add(at(last, t_end));
  };
  thread_local std::vector<DrawnRun> drawn_runs_of_profile;
  drawn_runs(profile, planned, sector_.view, visible, drawn_runs_of_profile);
  for (const DrawnRun& drawn : drawn_runs_of_profile) {
    const VisibleRun& run = drawn.run;
    const auto end = profile.after.begin() + run.last + 1;
    for (auto span = profile.after.begin() + run.first; span != end;) {
      // All that is drawn up to the next level ground, which isn't.
      const auto level = draws_level_ ? end : std::find(span, end, Span::level);
      if (span != level) {
        const auto first = static_cast<std::uint32_t>(span - profile.after.begin()),
                   last = static_cast<std::uint32_t>(level - profile.after.begin()) - 1;
        draw(drawn, first, last, first == run.first ? run.t_begin : 0,
             last == run.last ? run.t_end : 1);
      }
      if (level == end) break;
      close();
      span = level + 1;
    }
  }
  close();
}

} // namespace orograph
