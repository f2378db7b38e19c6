// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: T the target, A the camera's axis, elevation e how steeply A descends. A point's camera
// coordinates are x = (P-T).R, y = (P-T).F sin e + (z-T_z) cos e, and its depth along the axis is
// D + q with q = (P-T).F cos e - (z-T_z) sin e, where D is the distance from eye to target.
#include "view/place_view.hpp"

#include "geometry/error.hpp"
#include "view/extremes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace orograph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Angle kDefaultField = Angle::degrees(30);

std::string decimals(double value, int places) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", places, value);
  return text;
}

// Visibility plane to picture plane: the camera pitched down by the elevation, then rolled.
Homography picture_of(const View& view) {
  const double s_e = sin(view.elevation), c_e = cos(view.elevation);
  const Homography pitched =
      view.is_perspective() ? Homography{{1, 0, 0, 0, c_e, s_e, 0, -s_e, c_e}} : Homography{};
  const double s = sin(view.roll), c = cos(view.roll);
  return compose(Homography{{c, s, 0, -s, c, 0, 0, 0, 1}}, pitched);
}

// A picture coordinate of a ground point, as a function for `greatest`: sign * (x or y).
struct PictureCoordinate {
  const View& view;
  int row;
  double sign;

  double operator()(Vec3 ground) const {
    const ProfilePoint p = to_profile_frame(view, ground);
    if (view.is_perspective() && !(p.v >= view.near_m)) return kInfinity;
    const Vec2 plane = project(view, p);
    if (!(view.to_picture.w(plane) > 0)) return kInfinity;
    const Vec2 picture = view.to_picture(plane);
    return sign * (row == 0 ? picture.x : picture.y);
  }
};

double lowest_near_edge(const View& view, std::span<const OutlineEdge> outline) {
  const PictureCoordinate down{view, 1, -1};
  double lowest = kInfinity;
  for (const OutlineEdge& edge : outline) {
    const ProfilePoint a = to_profile_frame(view, edge.from), b = to_profile_frame(view, edge.to);
    // The terrain is on the left of a -> b; a ray comes in where it crosses from right to left.
    const double turn =
        view.is_perspective() ? a.v * b.u - a.u * b.v : (b.u - a.u) + view.x_per_v * (b.v - a.v);
    if (turn < 0) continue;
    lowest = std::min(lowest, -std::max(down(edge.from), down(edge.to)));
  }
  return lowest;
}

// The picture's bounding box; infinite where some ground has no picture.
Box2 picture_box(const View& view, const TerrainShape& terrain) {
  Box2 box;
  box.low.x = -greatest(terrain.points, PictureCoordinate{view, 0, -1});
  box.high.x = greatest(terrain.points, PictureCoordinate{view, 0, 1});
  box.high.y = greatest(terrain.points, PictureCoordinate{view, 1, 1});
  // "Lowest at the near edge" holds along the vertical of the visibility plane only.
  box.low.y = view.roll == Angle() ? lowest_near_edge(view, terrain.outline)
                                   : -greatest(terrain.points, PictureCoordinate{view, 1, -1});
  return box;
}

void put_eye_at_distance(View& view, double distance) {
  view.distance_m = distance;
  const Vec2 target{view.look_at_m.x, view.look_at_m.y};
  view.depth_origin_m = target - (distance * cos(view.elevation)) * view.forward;
  view.eye_z_m = view.look_at_m.z * view.exaggeration + distance * sin(view.elevation);
}

double picture_width(View& view, const TerrainShape& terrain, double distance) {
  put_eye_at_distance(view, distance);
  const double right = greatest(terrain.points, PictureCoordinate{view, 0, 1});
  if (right == kInfinity) return kInfinity;
  return right + greatest(terrain.points, PictureCoordinate{view, 0, -1});
}

// The distance at which the picture is as wide as asked, or none if it would be wider even where
// all ground is just in front of the eye. Width falls with distance; bisection on its logarithm.
std::optional<double> distance_for_width(View& view, const TerrainShape& terrain, double width) {
  double low = 0.5 * terrain.cell_m, high = terrain.cell_m;
  while (picture_width(view, terrain, high) > width) {
    low = high;
    high *= 2;
    if (!(high < 1e300)) return std::nullopt;
  }
  if (picture_width(view, terrain, low) < width) return low; // less than a cell wide
  for (int step = 0; step < 60 && high > low * (1 + 1e-9); ++step) {
    const double middle = std::sqrt(low * high);
    (picture_width(view, terrain, middle) > width ? low : high) = middle;
  }
  // Where the width jumps from infinite to less than asked, ground was behind the near plane, not
  // too wide.
  if (picture_width(view, terrain, high) < 0.999 * width) return std::nullopt;
  return high;
}

void set_elevation(View& view, Angle elevation) {
  view.elevation = elevation;
  if (view.projection == Projection::orthographic) {
    view.y_per_z = cos(elevation);
    view.y_per_v = sin(elevation);
  }
  view.to_picture = picture_of(view);
}

// The steepest elevation, to a tenth of a degree and rounded down, at which `works` holds.
template <class Works>
std::optional<double> steepest_elevation(View view, const Works& works) {
  int low = 0, high = 900; // tenths of a degree
  const auto works_at = [&](int tenths) {
    set_elevation(view, Angle::degrees(tenths / 10.0));
    return works(view);
  };
  if (!works_at(low)) return std::nullopt;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (works_at(middle) ? low : high) = middle;
  }
  return low / 10.0;
}

void frame_perspective(View& view, const ViewRequest& request, const TerrainShape& terrain) {
  const double width = 2 * tan(0.5 * request.field_of_view.value_or(kDefaultField));
  const auto distance = [&](View& v) -> std::optional<double> {
    if (!request.distance_m) return distance_for_width(v, terrain, width);
    if (picture_width(v, terrain, *request.distance_m) == kInfinity) return std::nullopt;
    return request.distance_m;
  };
  if (const auto found = distance(view)) {
    put_eye_at_distance(view, *found);
    return;
  }
  const std::string wrong = "perspective from " + decimals(view.elevation.in_degrees(), 1) +
                            " degrees would need ground beside or behind the eye";
  if (const auto steepest =
          steepest_elevation(view, [&](View& v) { return distance(v).has_value(); }))
    throw Error(wrong, "the steepest elevation that works here is " + decimals(*steepest, 1) +
                           " degrees, or use --projection orthographic");
  throw Error(wrong, std::string("use a ") +
                         (request.distance_m ? "greater --distance" : "smaller --fov") +
                         ", or --projection orthographic");
}

Box2 window_of_field(const View& view, Angle field, double aspect) {
  const double half_width = tan(0.5 * field), half_height = half_width * aspect;
  const Box2 window{{-half_width, -half_height}, {half_width, half_height}};
  // Along the ray to a window corner, v grows by cos e + y sin e.
  const double reach =
      half_height * std::abs(cos(view.roll)) + half_width * std::abs(sin(view.roll));
  if (!(cos(view.elevation) - reach * std::abs(sin(view.elevation)) > 0)) {
    const double steepest = std::floor(10 * (90 - atan2_angle(reach, 1).in_degrees())) / 10;
    throw Error("the page would show rays straight down or up from the eye",
                "with this field the axis may descend or climb by at most " +
                    decimals(steepest, 1) + " degrees; use a flatter view or a smaller --fov");
  }
  return window;
}

void look_from_eye(View& view, const ViewRequest& request) {
  const Vec3 eye = *request.eye_m;
  const Vec3 to_target{view.look_at_m.x - eye.x, view.look_at_m.y - eye.y,
                       view.exaggeration * (view.look_at_m.z - eye.z)};
  const double ground = std::hypot(to_target.x, to_target.y);
  if (ground == 0 && (to_target.z == 0 || view.is_perspective()))
    throw Error(to_target.z == 0 ? "eye and look-at point coincide"
                                 : "the look-at point is straight above or below the eye",
                "give a --look-at that lies aside");
  if (ground > 0) {
    view.forward = (1 / ground) * Vec2{to_target.x, to_target.y};
    view.right = {view.forward.y, 0 - view.forward.x};
  }
  set_elevation(view, atan2_angle(-to_target.z, ground));
  if (view.is_perspective()) {
    view.depth_origin_m = {eye.x, eye.y};
    view.eye_z_m = eye.z * view.exaggeration;
    view.distance_m = length(to_target);
  } else if (view.elevation < Angle()) {
    throw Error("a parallel view can't look up", "put the eye above the look-at point");
  }
}

void set_oblique(View& view, const Oblique& oblique) {
  view.x_per_v = oblique.length * cos(oblique.rise);
  view.y_per_v = oblique.length * sin(oblique.rise);
  view.y_per_z = 1;
  view.elevation = atan2_angle(view.y_per_v, std::hypot(1, view.x_per_v));
  view.to_picture = picture_of(view);
}

} // namespace

View place_view(const ViewRequest& request, const TerrainShape& terrain, double aspect) {
  View view;
  view.projection = request.projection;
  view.exaggeration = request.exaggeration;
  view.roll = request.roll;
  const Vec3 centre = terrain.box.centre();
  view.look_at_m = request.look_at_m.value_or(Vec3{centre.x, centre.y, terrain.mean_height_m});
  view.depth_origin_m = {view.look_at_m.x, view.look_at_m.y};
  view.near_m = view.is_perspective() ? kNearShareOfCell * terrain.cell_m : 0;

  if (request.eye_m) {
    look_from_eye(view, request);
  } else {
    view.forward = Vec2{} - direction_of_azimuth(request.from_azimuth); // without -0
    view.right = {view.forward.y, 0 - view.forward.x};
    set_elevation(view, request.from_elevation);
  }
  if (view.projection == Projection::oblique) set_oblique(view, request.oblique);

  const bool by_field =
      view.is_perspective() && (request.eye_m || (request.distance_m && request.field_of_view));
  view.frames_terrain = !by_field;
  if (by_field) {
    if (!request.eye_m) put_eye_at_distance(view, *request.distance_m);
    view.window = window_of_field(view, request.field_of_view.value_or(kDefaultField), aspect);
    if (greatest(terrain.points, [&](Vec3 p) { return to_profile_frame(view, p).v; }) < view.near_m)
      throw Error("all of the terrain is behind the eye", "turn --look-at towards it");
    return view;
  }
  if (view.is_perspective()) frame_perspective(view, request, terrain);
  view.window = picture_box(view, terrain);
  return view;
}

Vec2 plane_of_picture(const View& view, Vec2 picture) {
  const double s = sin(view.roll), c = cos(view.roll);
  const Vec2 upright{c * picture.x - s * picture.y, s * picture.x + c * picture.y};
  if (!view.is_perspective()) return upright;
  const double s_e = sin(view.elevation), c_e = cos(view.elevation);
  const double forward = c_e + upright.y * s_e;
  return {upright.x / forward, (upright.y * c_e - s_e) / forward};
}

std::array<Vec2, 4> shown_corners(const View& view) {
  const auto& [low, high] = view.window;
  return {plane_of_picture(view, low), plane_of_picture(view, {high.x, low.y}),
          plane_of_picture(view, high), plane_of_picture(view, {low.x, high.y})};
}

} // namespace orograph
