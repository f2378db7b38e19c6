// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/view_mapping.hpp"

#include "geometry/error.hpp"
#include "view/finite.hpp"
#include "view/model_transform.hpp"

namespace orograph {
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

} // namespace orograph
