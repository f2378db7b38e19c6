// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/parallel_sight.hpp"

#include "placing/geodesy.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

// Looks across the rays: a ray runs along its profiles, away from the viewer to the right.
View across_rays(const View& view, const PlacedView& placed, const MapFrame& map) {
  const double size = std::hypot(1, view.x_per_v);
  const Vec2 away = 1 / size * (view.forward + -view.x_per_v * view.right);
  View out = view;
  out.right = away;
  out.forward = {0 - away.y, away.x};
  out.drop = placed.curvature.applied
                 ? drop_in_frame(earth_drop(map, placed.curvature.refraction), out.forward)
                 : FrameDrop{};
  return out;
}

} // namespace

ParallelSight::ParallelSight(const TerrainData& terrain, const PlacedView& placed)
    : view_(placed.view), along_(across_rays(placed.view, placed, terrain.map)),
      near_m_(0.01 * placed.cell_m), cutter_(terrain.surface, along_, placed.level.triangles,
                                             placed.for_cutters, &placed.extent.box) {}

double ParallelSight::hidden_y(ProfilePoint at) const {
  const auto turned = [](const View& from, const View& to, ProfilePoint p) {
    const Vec2 ground = p.u * from.right + p.v * from.forward;
    return ProfilePoint{dot(ground, to.right), dot(ground, to.forward), p.z};
  };
  const ProfilePoint own = turned(view_, along_, at);
  thread_local Profile profile;
  const URange in_front{-std::numeric_limits<double>::infinity(), own.u};
  cutter_.cut(own.v, std::span(&in_front, 1), profile);
  const double own_y = project(view_, at).y;
  double highest = own_y;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (profile.u_m[i] > own.u - near_m_) break;
    if (std::isnan(profile.z_m[i])) continue;
    const ProfilePoint there = turned(along_, view_, {profile.u_m[i], own.v, profile.z_m[i]});
    highest = std::max(highest, project(view_, there).y);
  }
  return highest - own_y;
}

} // namespace orograph
