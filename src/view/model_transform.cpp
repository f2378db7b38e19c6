// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/model_transform.hpp"

#include "geometry/error.hpp"
#include "view/finite.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace orograph {

Eigen::Matrix4d translation(Vec3 by) {
  Eigen::Matrix4d t = Eigen::Matrix4d::Identity();
  t.col(3).head<3>() << by.x, by.y, by.z;
  return t;
}

Eigen::Matrix4d scaling(Vec3 factors) {
  return Eigen::Vector4d(factors.x, factors.y, factors.z, 1).asDiagonal();
}

Eigen::Matrix4d rotation(Vec3 axis, Angle angle) {
  require_finite(axis, "the axis of a rotation");
  require_finite(angle.in_degrees(), "the angle of a rotation");
  const Eigen::Vector3d a = Eigen::Vector3d(axis.x, axis.y, axis.z).stableNormalized();
  if (!(a.squaredNorm() > 0.5))
    throw Error("the axis of a rotation has length 0", "give it a direction, say (0, 0, 1)");
  Eigen::Matrix3d cross_a;
  cross_a << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  const Eigen::Matrix3d along = a * a.transpose();
  Eigen::Matrix4d r = Eigen::Matrix4d::Identity();
  r.topLeftCorner<3, 3>() =
      along + cos(angle) * (Eigen::Matrix3d::Identity() - along) + sin(angle) * cross_a;
  return r;
}

Eigen::Matrix4d shear_along_z(double x_per_z, double y_per_z) {
  Eigen::Matrix4d h = Eigen::Matrix4d::Identity();
  h(0, 2) = x_per_z;
  h(1, 2) = y_per_z;
  return h;
}

Eigen::Matrix4d model_transform(std::initializer_list<Eigen::Matrix4d> first_to_last) {
  Eigen::Matrix4d product = Eigen::Matrix4d::Identity();
  for (const Eigen::Matrix4d& next : first_to_last) product = next * product;
  require_model(product);
  return product;
}

void require_model(const Eigen::Matrix4d& model) {
  if (!model.allFinite())
    throw Error("a model's matrix holds a number that is not finite", "give finite numbers");
  if (model.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    throw Error("a model's matrix is not affine", "its last row should be 0 0 0 1");
  // Columns of length 1: the volume of the box that they span is then free of units.
  Eigen::Matrix3d edges = model.topLeftCorner<3, 3>();
  for (int column = 0; column < 3; ++column) edges.col(column).stableNormalize();
  if (!(std::abs(edges.determinant()) > 1e-14))
    throw Error("a model's matrix is singular, it flattens what it places",
                "no scale factor should be 0, and its three axes should not lie in one plane");
}

} // namespace orograph
