// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/profile_strokes.hpp"

#include "profiles/project_profile.hpp"

namespace orograph {
namespace {

// Whether vertex `from` and a later one are one point of the profile: only spans without any extent
// in X, which have no segment, lie between them.
bool joined(const Profile& profile, std::uint32_t from, std::uint32_t to) {
  if (from > to) return false;
  for (std::uint32_t i = from; i < to; ++i)
    if (profile.after[i] == Span::gap || profile.after[i] == Span::wall ||
        profile.u_m[i] < profile.u_m[i + 1])
      return false;
  return true;
}

} // namespace

StrokePoint ProfileStrokes::point(const Profile& profile, std::uint32_t left, double t) const {
  const auto at = [&](std::uint32_t i) {
    return ProfilePoint{profile.u_m[i], profile.depth_m, profile.z_m[i]};
  };
  ProfilePoint scene = point_between(at(left), at(left + 1), t);
  if (sector_.behind) scene = {-scene.u, -scene.v, scene.z};
  return {project_homogeneous(view_, scene), scene};
}

void ProfileStrokes::add(const Profile& profile, std::int32_t number,
                         const std::vector<Segment>& segments, const std::vector<Piece>& visible) {
  bool open = false, at_vertex = false;
  std::uint32_t open_vertex = 0; // where the open stroke ends, if it ends at a vertex
  for (const Piece& piece : visible) {
    const std::uint32_t left = left_vertex(segments[piece.segment]);
    if (profile.after[left] == Span::level && !draws_level_) continue;
    if (!(open && at_vertex && piece.t_begin <= 0 && joined(profile, open_vertex, left))) {
      if (open) builder_.end();
      builder_.begin(number, sector_.behind ? -profile.depth_m : profile.depth_m);
      builder_.add(point(profile, left, piece.t_begin));
      open = true;
    }
    builder_.add(point(profile, left, piece.t_end));
    at_vertex = piece.t_end >= 1;
    open_vertex = left + 1;
  }
  if (open) builder_.end();
}

} // namespace orograph
