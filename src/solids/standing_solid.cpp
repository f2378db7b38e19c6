// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/standing_solid.hpp"

#include "solids/scene_file.hpp"

#include <Eigen/LU>

namespace orograph {
namespace {

Eigen::Vector3d vector(Vec3 v) {
  return {v.x, v.y, v.z};
}

Eigen::Matrix3d columns(Vec3 x, Vec3 y, Vec3 z) {
  Eigen::Matrix3d matrix;
  matrix << vector(x), vector(y), vector(z);
  return matrix;
}

} // namespace

StandingSolid stand_at(const PlaceFrame& place, const SolidInstance& instance,
                       const SceneFile& scene) {
  const AffineMap& map = instance.to_place;
  const Eigen::Matrix3d axes = columns(place.east, place.north, place.up);
  const Eigen::Matrix3d linear = axes * columns(map.x, map.y, map.z);
  const Eigen::Vector3d moved = axes * vector(map.origin);
  const Solid& solid = scene.solids[instance.solid];
  StandingSolid standing{&solid, {}, linear.determinant() < 0, instance.place};
  standing.vertices_m.reserve(solid.vertices_m.size());
  for (const Vec3& v : solid.vertices_m) {
    const Eigen::Vector3d at = linear * vector(v) + moved;
    standing.vertices_m.push_back(place.at_m + Vec3{at.x(), at.y(), at.z()});
  }
  return standing;
}

} // namespace orograph
