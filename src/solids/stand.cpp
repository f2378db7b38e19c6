// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/stand.hpp"

#include <Eigen/LU>

namespace orograph {

StandingSolid stand_at(const PlaceFrame& place, const SolidInstance& instance,
                       const SceneFile& scene) {
  Eigen::Matrix3d axes;
  int column = 0;
  for (const Vec3& axis : {place.east, place.north, place.up})
    axes.col(column++) = Eigen::Vector3d(axis.x, axis.y, axis.z);
  const Eigen::Matrix3d linear = axes * instance.to_place.topLeftCorner<3, 3>();
  const Eigen::Vector3d moved = axes * instance.to_place.topRightCorner<3, 1>();
  const Solid& solid = scene.solids[instance.solid];
  StandingSolid standing{&solid, {}, linear.determinant() < 0, instance.place};
  standing.vertices_m.reserve(solid.vertices_m.size());
  for (const Vec3& v : solid.vertices_m) {
    const Eigen::Vector3d at = linear * Eigen::Vector3d(v.x, v.y, v.z) + moved;
    standing.vertices_m.push_back(place.at_m + Vec3{at.x(), at.y(), at.z()});
  }
  return standing;
}

} // namespace orograph
