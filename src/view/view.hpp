// SPDX-License-Identifier: GPL-3.0-or-later
// A view that has met its terrain: the profile frame and the visibility plane
// (docs/how-it-works.md).
#pragma once

#include "geometry/angle.hpp"
#include "geometry/box.hpp"
#include "geometry/homography.hpp"
#include "geometry/profile_point.hpp"
#include "geometry/vec.hpp"
#include "view/view_request.hpp"

#include <limits>

namespace orograph {

/// The same along u and v: a quadratic form, in metres.
struct FrameDrop {
  double per_uu = 0, per_uv = 0, per_vv = 0;
  double at(double u, double v) const { return (per_uu * u + per_uv * v) * u + per_vv * v * v; }
  bool any() const { return per_uu != 0 || per_uv != 0 || per_vv != 0; }
};

struct View {
  Projection projection = Projection::perspective;
  Vec2 depth_origin_m;   ///< under the eye; in a parallel view the point looked at
  Vec2 forward{0, 1};    ///< horizontal view direction F, unit
  Vec2 right{1, 0};      ///< R = F x up
  double eye_z_m = 0;    ///< exaggerated height of the eye; perspective only
  Vec3 look_at_m;        ///< target, ground frame, true height
  double distance_m = 0; ///< eye to target in the exaggerated scene; perspective only
  Angle elevation;       ///< how steeply the camera's axis, or a parallel view's rays, descend;
                         ///< negative looks up
  /// Of a parallel view: X = u + x_per_v v, Y = y_per_z z + y_per_v v. Orthographic from elevation
  /// e they are 0, cos e and sin e.
  double x_per_v = 0, y_per_z = 1, y_per_v = 0;
  Angle roll;
  double exaggeration = 1;
  FrameDrop drop;    ///< of every vertex, after exaggeration
  double near_m = 0; ///< v_near: nearer ground is cut away; perspective only
  /// Lines are drawn from this depth on, if it is beyond v_near: what might hide them is then all
  /// there, but for what stands in so small a share of the way to them.
  double drawn_from_m = -std::numeric_limits<double>::infinity();
  bool frames_terrain = true; ///< the window was made to hold all of the terrain
  Homography to_picture;      ///< visibility plane to picture plane (x right, y up)
  Box2 window;                ///< what of the picture plane is shown

  bool is_perspective() const { return projection == Projection::perspective; }
};

/// Ground frame (true height) to profile frame.
inline ProfilePoint to_profile_frame(const View& view, Vec3 ground_m) {
  const Vec2 from_origin = Vec2{ground_m.x, ground_m.y} - view.depth_origin_m;
  const double u = dot(from_origin, view.right), v = dot(from_origin, view.forward);
  return {u, v, ground_m.z * view.exaggeration - view.drop.at(u, v)};
}

/// Profile frame to visibility plane. REQUIRES p.v > 0 in perspective.
inline Vec2 project(const View& view, ProfilePoint p) {
  if (view.is_perspective()) {
    const double per_depth = 1 / p.v;
    return {p.u * per_depth, (p.z - view.eye_z_m) * per_depth};
  }
  return {p.u + p.v * view.x_per_v, p.z * view.y_per_z + p.v * view.y_per_v};
}

/// The same in homogeneous coordinates (X w, Y w, w), for any point, beside and behind the eye as
/// well: affine in p. In perspective w is the depth, in a parallel view 1.
inline Vec3 project_homogeneous(const View& view, ProfilePoint p) {
  if (view.is_perspective()) return {p.u, p.z - view.eye_z_m, p.v};
  const Vec2 plane = project(view, p);
  return {plane.x, plane.y, 1};
}

/// How u and z change along the ray of a point, away from the eye, in a metre of depth. REQUIRES
/// p.v > 0 in perspective. A ray straight down changes z by -infinity.
inline double u_along_ray(const View& view, ProfilePoint p) {
  return view.is_perspective() ? p.u / p.v : -view.x_per_v;
}
inline double z_along_ray(const View& view, ProfilePoint p) {
  return view.is_perspective() ? (p.z - view.eye_z_m) / p.v : -view.y_per_v / view.y_per_z;
}

/// Profile frame to ground frame (true height). Between vertices that sank with the earth's
/// curvature straight lines do too, so there heights are too low by up to an eighth of their
/// distance's square over the earth's radius: 0.02 mm at 30 m.
inline Vec3 to_ground_m(const View& view, ProfilePoint p) {
  const Vec2 ground = view.depth_origin_m + p.u * view.right + p.v * view.forward;
  return {ground.x, ground.y, (p.z + view.drop.at(p.u, p.v)) / view.exaggeration};
}

/// `drop` in the profile frame that looks along `forward`.
inline FrameDrop drop_in_frame(const EarthDrop& drop, Vec2 forward) {
  const Vec2 right{forward.y, 0 - forward.x};
  const double n = drop.per_north, e = drop.per_east;
  return {e * right.x * right.x + n * right.y * right.y,
          2 * (e * right.x * forward.x + n * right.y * forward.y),
          e * forward.x * forward.x + n * forward.y * forward.y};
}

/// Nearest ground that is drawn in perspective, as a share of a cell: closer than a hundredth of a
/// cell there is nothing but the triangle under the eye, and 1/v would only cost digits.
constexpr double kNearShareOfCell = 0.01;
/// Where the page shows rays beside the eye, the ground between the near planes of the two sectors
/// must not show: from a hundredth of a cell above the ground it is 2e-5 of that height wide.
constexpr double kNearShareBetweenSectors = 1e-7;

} // namespace orograph
