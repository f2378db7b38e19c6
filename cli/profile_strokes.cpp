// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/profile_strokes.hpp"

#include "profiles/project_profile.hpp"

namespace orograph {

StrokePoint ProfileStrokes::point(const Profile& profile, std::uint32_t left, double t) const {
  const auto at = [&](std::uint32_t i) {
    return ProfilePoint{profile.u_m[i], profile.depth_m, profile.z_m[i]};
  };
  ProfilePoint scene = point_between(at(left), at(left + 1), t);
  if (sector_.behind) scene = {-scene.u, -scene.v, scene.z};
  return {project_homogeneous(view_, scene), scene};
}

void ProfileStrokes::add(const Profile& profile, std::int32_t number,
                         std::span<const VisibleRun> visible) {
  const double depth_m = sector_.behind ? -profile.depth_m : profile.depth_m;
  bool open = false;
  std::uint32_t open_vertex = 0; // where the open stroke ends, if it ends at a vertex
  bool at_vertex = false;
  const auto close = [&] {
    if (open) builder_.end();
    open = false;
  };
  for (const VisibleRun& run : visible)
    for (std::uint32_t span = run.first; span <= run.last; ++span) {
      const double t_begin = span == run.first ? run.t_begin : 0;
      const double t_end = span == run.last ? run.t_end : 1;
      if (profile.after[span] == Span::level && !draws_level_) {
        close();
        continue;
      }
      if (!(open && at_vertex && t_begin <= 0 && open_vertex == span)) {
        close();
        builder_.begin(number, depth_m);
        builder_.add(point(profile, span, t_begin));
        open = true;
      }
      builder_.add(point(profile, span, t_end));
      at_vertex = t_end >= 1;
      open_vertex = span + 1;
    }
  close();
}

} // namespace orograph
