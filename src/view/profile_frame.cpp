// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/profile_frame.hpp"

#include "view/view_mapping.hpp"
#include "view/view_orientation.hpp"

namespace orograph {
namespace {

constexpr double kLevel = 1e-9; // radians; less is rounding of a direction
// Share of a unit direction of projection along F. With less, X and Y, which are divided by it,
// would lose more than three digits.
constexpr double kLeastAlongDepth = 1e-3;

// A vector of (u, v, n) in the world. The orientation is a rotation: its inverse is its transpose.
Vec3 in_world(const PhigsView& view, Vec3 uvn) {
  const Eigen::Vector3d world =
      view_orientation(view.vrp_m, view.vpn, view.vup).topLeftCorner<3, 3>().transpose() *
      Eigen::Vector3d(uvn.x, uvn.y, uvn.z);
  return {world.x(), world.y(), world.z()};
}

Vec3 unit(Vec3 a) {
  return (1 / length(a)) * a;
}

Vec2 horizontal(Vec3 a) {
  return {a.x, a.y};
}

// F before it is scaled to length 1.
Vec2 forward_of(const PhigsView& view) {
  const Vec2 into_plate = horizontal(in_world(view, {0, 0, -1}));
  const bool level_plate = length(into_plate) <= kLevel;
  const bool perspective = view.projection == PhigsProjection::perspective;
  const Vec3 direction = direction_of_projection(view);
  if (!level_plate && (perspective || dot(horizontal(direction), into_plate) >
                                          kLeastAlongDepth * length(into_plate)))
    return into_plate;
  if (!perspective && !is_vertical(direction)) return horizontal(direction);
  return horizontal(in_world(view, {0, 1, 0}));
}

} // namespace

Vec3 eye_m(const PhigsView& view) {
  return view.vrp_m + in_world(view, view.prp_m);
}

Vec3 direction_of_projection(const PhigsView& view) {
  canonical_volume(view); // throws where the direction is none
  const Vec2 centre = view.window_m.centre();
  return unit(in_world(view, unit(Vec3{centre.x, centre.y, 0} - view.prp_m)));
}

ProfileFrame frame_of(const PhigsView& view) {
  const Vec2 forward = forward_of(view);
  const Vec3 origin = view.projection == PhigsProjection::perspective
                          ? eye_m(view)
                          : Vec3{view.vrp_m.x, view.vrp_m.y, 0};
  return {origin, (1 / length(forward)) * forward};
}

} // namespace orograph
