// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/view_orientation.hpp"

#include "geometry/error.hpp"
#include "view/finite.hpp"
#include "view/model_transform.hpp"

#include <Eigen/Geometry>

namespace orograph {
namespace {

constexpr double kParallel = 1e-9; // radians; nearer, rounding would turn the picture visibly

Eigen::Vector3d unit(Vec3 direction, const std::string& what) {
  require_finite(direction, what);
  const Eigen::Vector3d result =
      Eigen::Vector3d(direction.x, direction.y, direction.z).stableNormalized();
  if (!(result.squaredNorm() > 0.5))
    throw Error(what + " has length 0", "give it a direction, say (0, 0, 1)");
  return result;
}

} // namespace

Eigen::Matrix4d view_orientation(Vec3 vrp_m, Vec3 vpn, Vec3 vup) {
  require_finite(vrp_m, "the view reference point (VRP)");
  const Eigen::Vector3d n = unit(vpn, "the view plane normal (VPN)");
  const Eigen::Vector3d up = unit(vup, "the view up vector (VUP)");
  Eigen::Vector3d u = up.cross(n);
  if (!(u.norm() > kParallel))
    throw Error("the view plane normal (VPN) is parallel to the view up vector (VUP)",
                "give a view up vector that points aside from the normal");
  u.normalize();
  u = (u - n * n.dot(u)).normalized(); // at right angles even where VUP is nearly parallel to n
  const Eigen::Vector3d v = n.cross(u);

  Eigen::Matrix4d turned = Eigen::Matrix4d::Identity();
  turned.block<1, 3>(0, 0) = u;
  turned.block<1, 3>(1, 0) = v;
  turned.block<1, 3>(2, 0) = n;
  return turned * translation(-1 * vrp_m);
}

Eigen::Matrix4d look_at(Vec3 eye_m, Vec3 target_m, Angle roll) {
  require_finite(eye_m, "the eye");
  require_finite(target_m, "the look-at point");
  require_finite(roll.in_degrees(), "the roll");
  const Vec3 backwards = eye_m - target_m;
  if (backwards == Vec3{})
    throw Error("eye and look-at point coincide", "give a look-at point that lies aside");
  if (!(std::hypot(backwards.x, backwards.y) > kParallel * length(backwards)))
    throw Error("the look-at point is straight above or below the eye, where no vertical can be "
                "kept",
                "give a look-at point that lies aside, or a view up vector (VUP) of its own");
  return rotation({0, 0, 1}, -roll) * view_orientation(eye_m, backwards, {0, 0, 1});
}

} // namespace orograph
