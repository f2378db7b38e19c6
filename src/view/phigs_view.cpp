// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/phigs_view.hpp"

#include "geometry/error.hpp"
#include "view/pipeline.hpp"
#include "view/sectors.hpp"

#include <cmath>

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
  // Straight down what is farther away is higher in the picture, straight up it is lower.
  return horizontal(in_world(view, {0, !perspective && direction.z > 0 ? -1.0 : 1.0, 0}));
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

Homography homography_of(const PhigsView& view, const ProfileFrame& frame,
                         const Box2& viewport_mm) {
  const Eigen::Matrix4d page = compose(Eigen::Matrix4d::Identity(), view, viewport_mm);
  const Vec2 right = frame.right();
  const Vec3 origin = frame.origin_m;
  const Eigen::Vector4d across(right.x, right.y, 0, 0), up(0, 0, 1, 0),
      forward(frame.forward.x, frame.forward.y, 0, 0), start(origin.x, origin.y, origin.z, 1);

  Eigen::Matrix<double, 4, 3> columns;
  if (view.projection == PhigsProjection::perspective) {
    columns << across, up, forward;
  } else {
    const Vec3 direction = direction_of_projection(view);
    const double away = direction.z > 0 ? -1 : 1; // of Y, a metre of depth where it is vertical
    columns << across, (is_vertical(direction) ? Eigen::Vector4d(away * forward) : up), start;
  }
  const Eigen::Matrix<double, 4, 3> image = page * columns;
  Homography homography;
  for (int column = 0; column < 3; ++column) {
    homography.m[column] = image(0, column);
    homography.m[3 + column] = image(1, column);
    homography.m[6 + column] = image(3, column);
  }
  return homography;
}

std::array<double, 4> volume_depth(const PhigsView& view, const ProfileFrame& frame) {
  const Eigen::Matrix4d page = compose(Eigen::Matrix4d::Identity(), view, {{0, 0}, {1, 1}});
  const auto of = [&](double x, double y, double z, double w) {
    return page.row(2).dot(Eigen::Vector4d(x, y, z, w));
  };
  const Vec2 right = frame.right();
  return {of(right.x, right.y, 0, 0), of(frame.forward.x, frame.forward.y, 0, 0), of(0, 0, 1, 0),
          of(frame.origin_m.x, frame.origin_m.y, 0, 1)};
}

namespace {

// The homography leads to a page, on which y runs down; the picture plane's y runs up.
Homography to_view_plane(const PhigsView& phigs, const ProfileFrame& frame) {
  const Box2& window = phigs.window_m;
  Homography out =
      homography_of(phigs, frame, {{window.low.x, -window.high.y}, {window.high.x, -window.low.y}});
  for (std::size_t i = 3; i < 6; ++i) out.m[i] *= -1;
  return out;
}

// How far the picture of what is vertical, or leads away where the view is straight down, is turned
// clockwise from upwards.
Angle roll_of(const View& view) {
  const Vec2 middle = view.window.centre();
  const Vec3 ray = ray_of_picture(view, middle);
  const Vec3 upwards = view.is_perspective() ? Vec3{0, ray.z, -ray.y} : Vec3{0, 1, 0};
  const Vec3 image = view.to_picture.of(upwards), centre = view.to_picture.of(ray);
  const double x = image.x - middle.x * image.z / centre.z,
               y = image.y - middle.y * image.z / centre.z;
  return atan2_angle(x, y);
}

void set_directions(View& view, const PhigsView& phigs, const ProfileFrame& frame) {
  const Vec3 direction = direction_of_projection(phigs);
  if (view.is_perspective()) {
    view.depth_origin_m = {frame.origin_m.x, frame.origin_m.y};
    view.eye_z_m = frame.origin_m.z;
    view.distance_m = length(frame.origin_m - phigs.vrp_m);
    view.elevation = atan2_angle(phigs.vpn.z, std::hypot(phigs.vpn.x, phigs.vpn.y));
    return;
  }
  view.depth_origin_m = {phigs.vrp_m.x, phigs.vrp_m.y};
  view.elevation = atan2_angle(-direction.z, std::hypot(direction.x, direction.y));
  if (is_vertical(direction)) {
    view.y_per_z = 0;
    view.y_per_v = direction.z > 0 ? -1 : 1;
    return;
  }
  const Vec2 along{direction.x, direction.y};
  const double d_u = dot(along, view.right), d_v = dot(along, view.forward);
  view.x_per_v = 0 - d_u / d_v;
  view.y_per_z = 1;
  view.y_per_v = 0 - direction.z / d_v;
}

Projection kind_of(const PhigsView& phigs) {
  if (phigs.projection == PhigsProjection::perspective) return Projection::perspective;
  const Vec2 centre = phigs.window_m.centre();
  return centre == Vec2{phigs.prp_m.x, phigs.prp_m.y} ? Projection::orthographic
                                                      : Projection::oblique;
}

} // namespace

View place_phigs_view(const PhigsView& phigs, double exaggeration, double cell_m,
                      const EarthDrop& drop) {
  const ProfileFrame frame = frame_of(phigs);
  View view;
  view.projection = kind_of(phigs);
  view.forward = frame.forward;
  view.right = frame.right();
  view.exaggeration = exaggeration;
  view.drop = drop_in_frame(drop, view.forward);
  view.look_at_m = {phigs.vrp_m.x, phigs.vrp_m.y, phigs.vrp_m.z / exaggeration};
  view.frames_terrain = false;
  view.window = phigs.window_m;
  set_directions(view, phigs, frame);
  view.to_picture = to_view_plane(phigs, frame);
  view.roll = roll_of(view);
  view.near_m = near_plane_m(view, cell_m);
  return view;
}

PhigsView phigs_of(const View& view) {
  PhigsView phigs;
  const Vec3 forward{view.forward.x, view.forward.y, 0}, right{view.right.x, view.right.y, 0},
      up{0, 0, 1};
  const double c = cos(view.elevation), s = sin(view.elevation);
  const bool upright_plate = view.projection == Projection::oblique;
  const Vec3 axis = upright_plate ? forward : c * forward - s * up;
  phigs.vpn = -1.0 * axis;
  // The picture turns clockwise by the roll.
  phigs.vup = cos(view.roll) * cross(right, axis) - sin(view.roll) * right;
  phigs.window_m = view.window;
  if (view.is_perspective()) {
    phigs.vrp_m = Vec3{view.depth_origin_m.x, view.depth_origin_m.y, view.eye_z_m} + axis;
    phigs.prp_m = {0, 0, 1};
    return phigs;
  }
  phigs.projection = PhigsProjection::parallel;
  // A parallel picture is measured from the depth origin at height 0.
  phigs.vrp_m = {view.depth_origin_m.x, view.depth_origin_m.y, 0};
  const Vec2 centre = view.window.centre();
  phigs.prp_m = {centre.x, centre.y, 1};
  if (upright_plate) { // from the window's centre towards the viewer
    phigs.prp_m.x += cos(view.roll) * view.x_per_v + sin(view.roll) * view.y_per_v;
    phigs.prp_m.y += cos(view.roll) * view.y_per_v - sin(view.roll) * view.x_per_v;
  }
  return phigs;
}

} // namespace orograph
