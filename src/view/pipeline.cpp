// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/pipeline.hpp"

#include "geometry/clip_by_planes.hpp"
#include "geometry/error.hpp"
#include "geometry/vec.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <string>

namespace orograph {
namespace {

// Throws Error, which begins with `what`, if it is infinite or not a number.
void require_finite(double value, const std::string& what) {
  if (!std::isfinite(value)) throw Error(what + " is not a finite number", "give finite numbers");
}
void require_finite(Vec2 value, const std::string& what) {
  require_finite(value.x, what);
  require_finite(value.y, what);
}
void require_finite(Vec3 value, const std::string& what) {
  require_finite(Vec2{value.x, value.y}, what);
  require_finite(value.z, what);
}

} // namespace

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

namespace {

void require_eye_in_front(const PhigsView& view) {
  const bool perspective = view.projection == PhigsProjection::perspective;
  if (view.prp_m.z == 0)
    throw Error(perspective ? "the eye (PRP) lies on the view plane"
                            : "the direction of projection lies in the view plane",
                "put the projection reference point (PRP) at n > 0");
  if (view.prp_m.z < 0)
    throw Error("the projection reference point (PRP) lies behind the view plane",
                "put it at n > 0, the side that the view plane normal (VPN) points to");
  if (perspective && !(view.front_m < view.prp_m.z))
    throw Error("the front plane lies at the eye (PRP) or behind it",
                "put the front plane at a smaller n than the eye's");
}

void require_view_volume(const PhigsView& view) {
  require_finite(view.prp_m, "the projection reference point (PRP)");
  require_finite(view.window_m.low, "the window");
  require_finite(view.window_m.high, "the window");
  require_finite(view.front_m, "the front plane");
  require_finite(view.back_m, "the back plane");
  if (!(view.window_m.width() > 0 && view.window_m.height() > 0))
    throw Error("the window is empty", "umin should be less than umax, and vmin less than vmax");
  if (!(view.back_m < view.front_m))
    throw Error("the front plane lies at the back plane or behind it",
                "put the front plane at a greater n than the back plane's");
  require_eye_in_front(view);
}

// Lines along the direction of projection, or along the pyramid's axis, become parallel to z.
Eigen::Matrix4d straightening(const PhigsView& view) {
  const Vec2 centre = view.window_m.centre();
  const Vec3 direction = Vec3{centre.x, centre.y, 0} - view.prp_m;
  return shear_along_z(-direction.x / direction.z, -direction.y / direction.z);
}

} // namespace

CanonicalVolume canonical_volume(const PhigsView& view) {
  require_view_volume(view);
  if (view.projection == PhigsProjection::parallel) return {view.projection, 0};
  const double eye_n = view.prp_m.z;
  return {view.projection, -(eye_n - view.front_m) / (eye_n - view.back_m)};
}

Eigen::Matrix4d parallel_mapping(const PhigsView& view) {
  require_view_volume(view);
  const Vec2 centre = view.window_m.centre();
  return scaling({2 / view.window_m.width(), 2 / view.window_m.height(),
                  1 / (view.front_m - view.back_m)}) *
         translation({-centre.x, -centre.y, -view.front_m}) * straightening(view);
}

Eigen::Matrix4d perspective_mapping(const PhigsView& view) {
  require_view_volume(view);
  const double eye_n = view.prp_m.z, to_back = 1 / (eye_n - view.back_m);
  const Eigen::Matrix4d unit_slopes =
      scaling({2 * eye_n / view.window_m.width(), 2 * eye_n / view.window_m.height(), 1});
  return scaling({to_back, to_back, to_back}) * unit_slopes * straightening(view) *
         translation(-1 * view.prp_m);
}

Eigen::Matrix4d view_mapping(const PhigsView& view) {
  return view.projection == PhigsProjection::perspective ? perspective_mapping(view)
                                                         : parallel_mapping(view);
}

Eigen::Matrix4d perspective_transformation(double z_min) {
  Eigen::Matrix4d p = Eigen::Matrix4d::Identity();
  p(2, 2) = 1 / (1 + z_min);
  p(2, 3) = -z_min / (1 + z_min);
  p(3, 2) = -1;
  p(3, 3) = 0;
  return p;
}

namespace {

// Left, right, below, above, back, front. That w >= 0 follows from back and front.
PlaneValues plane_values(const Eigen::Vector4d& p, const CanonicalVolume& volume) {
  const double x = p.x(), y = p.y(), z = p.z(), w = p.w();
  if (volume.projection == PhigsProjection::parallel)
    return {w + x, w - x, w + y, w - y, w + z, -z};
  return {x - z, -z - x, y - z, -z - y, w + z, std::fma(volume.z_min, w, -z)};
}

// From the nearer end, so that ends stay what they are.
Eigen::Vector4d point_at(const Eigen::Vector4d& from, const Eigen::Vector4d& to, double t) {
  if (t <= 0.5) return from + t * (to - from);
  return to - (1 - t) * (to - from);
}

} // namespace

std::optional<AcceptedPart> clip_to_volume(const Eigen::Vector4d& from, const Eigen::Vector4d& to,
                                           const CanonicalVolume& volume) {
  const auto shares = clip_by_planes(plane_values(from, volume), plane_values(to, volume));
  if (!shares) return std::nullopt;
  const auto [begin, end] = *shares;
  return AcceptedPart{begin, end, point_at(from, to, begin), point_at(from, to, end)};
}

namespace {

void require_rectangle(const Box2& box, const std::string& what) {
  require_finite(box.low, what);
  require_finite(box.high, what);
  if (!(box.width() > 0 && box.height() > 0))
    throw Error(what + " is empty", "its width and height should be greater than 0");
}

} // namespace

Eigen::Matrix4d workstation_transformation(const Box2& window, const Box2& viewport_mm) {
  require_rectangle(window, "the window on the canonical volume");
  require_rectangle(viewport_mm, "the viewport");
  return translation({viewport_mm.low.x, viewport_mm.high.y, 0}) *
         scaling(
             {viewport_mm.width() / window.width(), -viewport_mm.height() / window.height(), 1}) *
         translation({-window.low.x, -window.low.y, 0});
}

Eigen::Matrix4d compose(const Eigen::Matrix4d& model, const PhigsView& view,
                        const Box2& viewport_mm) {
  require_model(model);
  const Eigen::Matrix4d orientation = view_orientation(view.vrp_m, view.vpn, view.vup);
  const Eigen::Matrix4d mapping = view_mapping(view);
  const CanonicalVolume volume = canonical_volume(view);
  const Eigen::Matrix4d to_parallel = volume.projection == PhigsProjection::perspective
                                          ? perspective_transformation(volume.z_min)
                                          : Eigen::Matrix4d::Identity();
  const Eigen::Matrix4d to_page = workstation_transformation(kWholeWindow, viewport_mm);

  const Eigen::Matrix4d all = to_page * to_parallel * mapping * orientation * model;
  if (!all.allFinite())
    throw Error("the view's numbers are too large or too small beside each other",
                "give window, planes and eye in metres of the scene");
  return all;
}

} // namespace orograph
