// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: T the target, A the camera's axis, elevation e how steeply A descends. A point's camera
// coordinates are x = (P-T).R, y = (P-T).F sin e + (z-T_z) cos e, and its depth along the axis is
// D + q with q = (P-T).F cos e - (z-T_z) sin e, where D is the distance from eye to target.
#include "view/place_view.hpp"

#include "geometry/blocked_points.hpp"
#include "geometry/error.hpp"
#include "view/picture_ends.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace orograph {
namespace {

const Angle kDefaultField = Angle::degrees(30);

// Visibility plane to picture plane: the camera pitched down by the elevation, then rolled.
Homography picture_of(const View& view) {
  const double s_e = sin(view.elevation), c_e = cos(view.elevation);
  const Homography pitched =
      view.is_perspective() ? Homography{{1, 0, 0, 0, c_e, s_e, 0, -s_e, c_e}} : Homography{};
  const double s = sin(view.roll), c = cos(view.roll);
  return compose(Homography{{c, s, 0, -s, c, 0, 0, 0, 1}}, pitched);
}

double lowest_near_edge(const View& view, const TerrainShape& terrain) {
  const PictureCoordinate down{view, view.near_m, 1, -1};
  double lowest = kInfinity;
  for (const OutlineEdge& edge : terrain.outline) {
    const ProfilePoint a = to_profile_frame(view, edge.from), b = to_profile_frame(view, edge.to);
    // The terrain is on the left of a -> b; a ray comes in where it crosses from right to left.
    const double turn =
        view.is_perspective() ? a.v * b.u - a.u * b.v : (b.u - a.u) + view.x_per_v * (b.v - a.v);
    if (turn < 0) continue;
    lowest = std::min(lowest, -std::max(down(edge.from), down(edge.to)));
  }
  const auto bound = [&](const Box3& box, double best) { return down.bound(box, best); };
  lowest = std::min(lowest, -greatest(terrain.beside, down, bound, {}).value);
  return lowest;
}

// The picture's bounding box. REQUIRES that all ground has a picture.
Box2 picture_box(const View& view, const TerrainShape& terrain, bool both_sides,
                 PictureEnds& ends) {
  const auto most = [&](int row, double sign) {
    return sign * greatest(terrain, PictureCoordinate{view, -kInfinity, row, sign}, ends);
  };
  Box2 box{{most(0, -1), 0}, {most(0, 1), most(1, 1)}};
  // "Lowest at the near edge" holds along the vertical of the visibility plane only, in front of
  // the eye, and of the upper side.
  const auto nearness = [&](Vec3 p) { return -to_profile_frame(view, p).v; };
  const double nearest =
      std::max(greatest(terrain.points, nearness), greatest(terrain.beside, nearness));
  const bool in_front = !view.is_perspective() || nearest <= -view.near_m;
  const bool at_edge = view.roll == Angle() && in_front && !both_sides;
  box.low.y = at_edge ? lowest_near_edge(view, terrain) : most(1, -1);
  return box;
}

void put_eye_at_distance(View& view, double distance) {
  view.distance_m = distance;
  const Vec2 target{view.look_at_m.x, view.look_at_m.y};
  const double away = distance * cos(view.elevation);
  view.depth_origin_m = target - away * view.forward;
  view.eye_z_m =
      view.look_at_m.z * view.exaggeration - view.drop.at(0, away) + distance * sin(view.elevation);
}

// What has to fit the field: the width of the picture of ground that is all in front of the eye;
// where some of it may be beside or below, the longer side, since a picture that is narrow could
// else take in all from straight down to the eye's own height.
enum class Fitted { width_in_front, longer_side };

// Of the picture from a distance; `most_of` tells the most of a picture coordinate.
template <class MostOf>
double size_from(View& view, double distance, Fitted fitted, const MostOf& most_of) {
  put_eye_at_distance(view, distance);
  const bool in_front = fitted == Fitted::width_in_front;
  const double nearest_m = in_front ? view.near_m : -kInfinity;
  const auto extent = [&](int row) {
    const double most = most_of(PictureCoordinate{view, nearest_m, row, 1});
    if (most == kInfinity) return kInfinity;
    return most + most_of(PictureCoordinate{view, nearest_m, row, -1});
  };
  return in_front ? extent(0) : std::max(extent(0), extent(1));
}

double picture_size(View& view, const TerrainShape& terrain, double distance, Fitted fitted,
                    PictureEnds& ends) {
  return size_from(view, distance, fitted, [&](const PictureCoordinate& coordinate) {
    return greatest(terrain, coordinate, ends);
  });
}

// No more than that: the picture of some points.
double size_of_ends(View& view, double distance, Fitted fitted, PictureEnds& ends) {
  return size_from(view, distance, fitted, [&](const PictureCoordinate& coordinate) {
    const std::optional<Vec3>& end = ends.of(coordinate);
    double most = end ? coordinate(*end) : -kInfinity;
    for (const Vec3& point : ends.nearest) most = std::max(most, coordinate(point));
    return most;
  });
}

// Whether pictures are larger than asked, as they are from nearer than some distance. Nearly always
// that is told without a look at the terrain: by the points that bound the picture, or by a picture
// from nearer by that was no larger.
struct LargerThan {
  double size;
  View& view;
  const TerrainShape& terrain;
  Fitted fitted;
  PictureEnds& ends;
  double fits_from = kInfinity; // distances from which the picture is known not to be larger

  bool operator()(double distance) {
    if (distance >= fits_from) return false;
    if (size_of_ends(view, distance, fitted, ends) > size) return true;
    if (picture_size(view, terrain, distance, fitted, ends) > size) return true;
    fits_from = distance;
    // From where the points that bound it now just fit, others mostly fit as well; where not, they
    // bound it farther away.
    for (double from = nearest_of_ends(0.5 * distance); from < fits_from;
         from = nearest_of_ends(from))
      if (picture_size(view, terrain, from, fitted, ends) <= size) fits_from = from;
    return false;
  }

  // About the least distance, between one and `fits_from`, from which the ends aren't too large.
  double nearest_of_ends(double low) {
    double high = fits_from;
    while (high > low * (1 + 1e-10)) {
      const double middle = 0.5 * (low + high);
      (size_of_ends(view, middle, fitted, ends) > size ? low : high) = middle;
    }
    return high;
  }
};

// The distance at which the picture is as large as asked, or none if it would be larger even where
// all ground is just in front of the eye. Size falls with distance; bisection on its logarithm.
std::optional<double> distance_for_size(View& view, const TerrainShape& terrain, double size,
                                        Fitted fitted, PictureEnds& ends) {
  LargerThan is_larger{size, view, terrain, fitted, ends};
  double low = 0.5 * terrain.cell_m, high = terrain.cell_m;
  while (is_larger(high)) {
    low = high;
    high *= 2;
    if (!(high < 1e300)) return std::nullopt;
  }
  // Mostly the points that bound it tell.
  const auto is_smaller = [&](double distance, double than) {
    return size_of_ends(view, distance, fitted, ends) < than &&
           picture_size(view, terrain, distance, fitted, ends) < than;
  };
  if (is_smaller(low, size)) return low; // less than a cell wide
  for (int step = 0; step < 60 && high > low * (1 + 1e-9); ++step) {
    const double middle = std::sqrt(low * high);
    (is_larger(middle) ? low : high) = middle;
  }
  // Where the size jumps from infinite to less than asked, ground was behind the near plane, not
  // too wide.
  if (is_smaller(high, 0.999 * size)) return std::nullopt;
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

// Whether there is a place from which all of the terrain has a picture.
bool put_eye_to_frame(View& view, const ViewRequest& request, const TerrainShape& terrain,
                      PictureEnds& ends) {
  const double size = 2 * tan(0.5 * request.field_of_view.value_or(kDefaultField));
  for (const Fitted fitted : {Fitted::width_in_front, Fitted::longer_side}) {
    if (request.distance_m) {
      if (picture_size(view, terrain, *request.distance_m, fitted, ends) < kInfinity) return true;
    } else if (const auto found = distance_for_size(view, terrain, size, fitted, ends)) {
      put_eye_at_distance(view, *found);
      return true;
    }
  }
  return false;
}

// Where the ground sinks with the square of its distance from the eye, the horizontal that
// elevations are above is the target's own: it slopes towards the eye by twice the drop over the
// distance, 16 degrees at 2000 km, and with an elevation below that all ground would be turned
// away.
//
// `put_eye` puts the eye where the view's elevation says, and tells whether it could. Where it
// couldn't after a step, on a planet hardly larger than the terrain, the place before it stays.
template <class PutEye>
bool look_from_above(View& view, const ViewRequest& request, const PutEye& put_eye) {
  constexpr int kMostSteps = 30; // each is nearer by the slope's share: on the earth three do
  constexpr double kSame_deg = 1e-5;
  if (!put_eye()) return false;
  const bool is_sloping = view.drop.any() && request.elevation_above == Horizontal::of_target;
  double change_deg = is_sloping ? 1 : 0;
  for (int i = 0; i < kMostSteps && change_deg > kSame_deg; ++i) {
    const View before = view;
    const double away_m = view.distance_m * cos(view.elevation);
    set_elevation(view, request.from_elevation + atan2_angle(2 * view.drop.per_vv * away_m, 1));
    change_deg = std::abs((view.elevation + -before.elevation).in_degrees());
    if (!put_eye()) {
      view = before;
      break;
    }
  }
  return true;
}

Box2 window_of_field(Angle field, double aspect) {
  const double half_width = tan(0.5 * field), half_height = half_width * aspect;
  return {{-half_width, -half_height}, {half_width, half_height}};
}

void look_along(View& view, const LookDirection& look, Vec3 eye) {
  view.forward = direction_of_azimuth(look.azimuth);
  view.right = {view.forward.y, 0 - view.forward.x};
  set_elevation(view, Angle() + -look.pitch); // without -0
  view.depth_origin_m = {eye.x, eye.y};
  view.eye_z_m = eye.z * view.exaggeration;
  view.distance_m = 1;
  const Vec2 ahead = cos(look.pitch) * view.forward;
  view.look_at_m = eye + Vec3{ahead.x, ahead.y, sin(look.pitch) / view.exaggeration};
}

void look_from_eye(View& view, const ViewRequest& request) {
  const Vec3 eye = *request.eye_m;
  const double east = view.look_at_m.x - eye.x, north = view.look_at_m.y - eye.y;
  const double sunk = view.is_perspective() ? request.drop.per_north * north * north +
                                                  request.drop.per_east * east * east
                                            : 0;
  const Vec3 to_target{east, north, view.exaggeration * (view.look_at_m.z - eye.z) - sunk};
  const double ground = std::hypot(to_target.x, to_target.y);
  if (ground == 0 && to_target.z == 0)
    throw Error("eye and look-at point coincide", "give a `look_at_map` that lies aside");
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

View level_view(const ViewRequest& request, double cell_m) {
  View view;
  view.exaggeration = request.exaggeration;
  look_along(view, {request.look->azimuth, Angle()}, *request.eye_m);
  view.drop = drop_in_frame(request.drop, view.forward);
  view.near_m = kNearShareOfCell * cell_m;
  view.frames_terrain = false;
  return view;
}

View place_view(const ViewRequest& request, const TerrainShape& terrain, double aspect) {
  View view;
  view.projection = request.projection;
  view.exaggeration = request.exaggeration;
  view.roll = request.roll;
  const Vec3 centre = terrain.box.centre();
  view.look_at_m = request.look_at_m.value_or(Vec3{centre.x, centre.y, terrain.mean_height_m});
  view.depth_origin_m = {view.look_at_m.x, view.look_at_m.y};
  view.near_m = view.is_perspective() ? kNearShareOfCell * terrain.cell_m : 0;

  // Also where the eye is straight above what it looks at.
  view.forward = Vec2{} - direction_of_azimuth(request.from_azimuth); // without -0
  view.right = {view.forward.y, 0 - view.forward.x};
  if (request.eye_m && request.look)
    look_along(view, *request.look, *request.eye_m);
  else if (request.eye_m)
    look_from_eye(view, request);
  else
    set_elevation(view, request.from_elevation);
  if (view.projection == Projection::oblique) set_oblique(view, request.oblique);
  view.drop = drop_in_frame(request.drop, view.forward);

  const bool by_field =
      view.is_perspective() && (request.eye_m || (request.distance_m && request.field_of_view));
  view.frames_terrain = !by_field;
  if (by_field) {
    if (!request.eye_m)
      look_from_above(view, request, [&] {
        put_eye_at_distance(view, *request.distance_m);
        return true;
      });
    view.window = window_of_field(request.field_of_view.value_or(kDefaultField), aspect);
    const auto in_front_of_picture = [&](Vec3 p) {
      return view.to_picture.of(project_homogeneous(view, to_profile_frame(view, p))).z;
    };
    if (std::max(greatest(terrain.points, in_front_of_picture),
                 greatest(terrain.beside, in_front_of_picture)) <= 0)
      throw Error("all of the terrain is behind the eye", "turn the view towards it");
  } else {
    PictureEnds ends(view, terrain.outline);
    if (view.is_perspective() && !look_from_above(view, request, [&] {
          return put_eye_to_frame(view, request, terrain, ends);
        }))
      throw Error(
          "part of the terrain is beside or behind the eye, where it has no picture",
          "use a greater `distance_m`, or give `field_of_view` too, to show a part of the terrain");
    view.window = picture_box(view, terrain, request.both_sides, ends);
  }
  view.near_m = near_plane_m(view, terrain.cell_m);
  return view;
}

} // namespace orograph
