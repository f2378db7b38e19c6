// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a view against a pinhole camera, and what must never be mirrored or lean.
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/view/made_terrain.hpp"
#include "view/sectors.hpp"

using namespace orograph;

namespace {

ViewRequest random_eye(Random& random, Projection projection) {
  ViewRequest request;
  request.projection = projection;
  const double azimuth = random.between(0, 2 * std::numbers::pi);
  const double descent =
      projection == Projection::perspective ? random.between(-60, 60) : random.between(0, 85);
  const double distance = random.between(50, 5000);
  request.exaggeration = random.pick({1.0, 2.0});
  request.look_at_m = Vec3{random.between(-500, 500), random.between(-500, 500), 50};
  const double tangent = std::tan(descent * std::numbers::pi / 180);
  request.eye_m =
      *request.look_at_m + Vec3{distance * std::sin(azimuth), distance * std::cos(azimuth),
                                distance * tangent / request.exaggeration};
  request.field_of_view = Angle::degrees(10);
  request.roll = Angle::degrees(random.pick({0.0, 90.0, random.between(-180, 180)}));
  return request;
}

Pinhole camera_of(const ViewRequest& request) {
  const Vec3 eye = exaggerated(*request.eye_m, request.exaggeration);
  const Vec3 target = exaggerated(*request.look_at_m, request.exaggeration);
  Pinhole camera = pinhole(eye, target - eye, request.roll.in_degrees());
  camera.parallel = request.projection == Projection::orthographic;
  return camera;
}

// Terrain all around, so that no eye has it all behind.
MadeTerrain everywhere() {
  Random random(1);
  MadeTerrain terrain = made_terrain(random, 3);
  const GridLattice lattice{2, 2, {-1e5, 1e5}, {2e5, 0}, {0, -2e5}};
  *terrain.grid = made_grid(random, lattice, {});
  terrain.extent = extent_of(*terrain.grid);
  return terrain;
}

} // namespace

TEST_CASE("the picture is a pinhole camera's") {
  const MadeTerrain terrain = everywhere();
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const auto projection = random.pick({Projection::perspective, Projection::orthographic});
    const ViewRequest request = random_eye(random, projection);
    const Pinhole camera = camera_of(request);
    const View view = place_view(request, terrain.shape(), 0.7);
    // A parallel picture is measured from the point looked at, at height 0; the pinhole's from the
    // eye. Only differences are the same.
    const Vec3 target = *request.look_at_m;
    Vec2 shift;
    if (camera.parallel)
      shift = picture_of(view, target) - camera.picture(exaggerated(target, request.exaggeration));
    for (int i = 0; i < 20; ++i) {
      const Vec3 p = target + Vec3{random.between(-2000, 2000), random.between(-2000, 2000),
                                   random.between(-500, 500)};
      const Vec3 scene = exaggerated(p, request.exaggeration);
      const ProfilePoint frame = to_profile_frame(view, p);
      if (!camera.parallel && (frame.v < 1 || camera.along(scene) < 1)) continue;
      const Vec2 expected = camera.picture(scene) + shift, found = picture_of(view, p);
      CAPTURE(p.x, p.y, p.z, expected.x, expected.y, found.x, found.y);
      // The homography divides numbers up to 1/cos, 1/v: relative to the plane's coordinates.
      const double size = std::max({1.0, largest(project(view, frame)), largest(expected)});
      REQUIRE(largest(found - expected) <= 1e-10 * size);
      const Vec3 ray = ray_of_picture(view, found);
      const Vec2 plane = project(view, frame), back{ray.x / ray.z, ray.y / ray.z};
      REQUIRE(largest(back - plane) <= 1e-10 * std::max(1.0, largest(plane)) * size);
      const Vec3 ground = to_ground_m(view, frame);
      REQUIRE(length(ground - p) <= 1e-11 * 1e4);
    }
    if (!camera.parallel) {
      REQUIRE(largest(picture_of(view, target)) <= 1e-12);
      const auto corners = corner_rays(view);
      const auto& [low, high] = view.window;
      const Vec2 window[4] = {low, {high.x, low.y}, high, {low.x, high.y}};
      for (std::size_t i = 0; i < 4; ++i)
        REQUIRE(length(view.to_picture.of(corners[i]) - Vec3{window[i].x, window[i].y, 1}) <=
                1e-12);
    }
  }
}

TEST_CASE("nothing is mirrored") {
  Random random(5);
  const MadeTerrain terrain = made_terrain(random, 5);
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const double azimuth : {180.0, 0.0, 90.0, 270.0, 33.0}) {
      ViewRequest request;
      request.projection = projection;
      request.from_azimuth = Angle::degrees(azimuth);
      const View view = place_view(request, terrain.shape(), 0.7);
      const double look = (azimuth + 180) * std::numbers::pi / 180;
      const Vec3 ahead{std::sin(look), std::cos(look), 0},
          right{std::cos(look), -std::sin(look), 0};
      const Vec3 target = view.look_at_m;
      const Vec2 centre = picture_of(view, target);
      CHECK(picture_of(view, target + right).x > centre.x);
      CHECK(picture_of(view, target + ahead).y > centre.y);
      CHECK(picture_of(view, target + Vec3{0, 0, 1}).y > centre.y);
      CHECK(to_profile_frame(view, target + ahead).v > to_profile_frame(view, target).v);
      // Where the viewer stands: on the azimuth's side.
      if (projection == Projection::perspective)
        CHECK(dot(view.depth_origin_m - Vec2{target.x, target.y}, Vec2{ahead.x, ahead.y}) < 0);
    }
}

TEST_CASE("a view from the south looks north, to the last bit") {
  Random random(5);
  const MadeTerrain terrain = made_terrain(random, 5);
  const View view = place_view({}, terrain.shape(), 0.7);
  CHECK(view.forward == Vec2{0, 1});
  CHECK(view.right == Vec2{1, 0});
}

TEST_CASE("verticals are vertical on the axis, and everywhere in a level or parallel view") {
  Random random(6);
  const MadeTerrain terrain = made_terrain(random, 9);
  const auto lean = [](const View& view, Vec3 foot) {
    return picture_of(view, foot + Vec3{0, 0, 50}).x - picture_of(view, foot).x;
  };
  ViewRequest request;
  request.from_azimuth = Angle::degrees(77);
  const View pitched = place_view(request, terrain.shape(), 0.7);
  CHECK(std::abs(lean(pitched, pitched.look_at_m)) <= 1e-15);
  request.from_elevation = Angle();
  const View level = place_view(request, terrain.shape(), 0.7);
  for (const Vec3& p : terrain.vertices) CHECK(lean(level, p) == 0);
  request.from_elevation = Angle::degrees(40);
  request.projection = Projection::orthographic;
  const View parallel = place_view(request, terrain.shape(), 0.7);
  for (const Vec3& p : terrain.vertices) CHECK(lean(parallel, p) == 0);
}

TEST_CASE("roll turns the picture clockwise") {
  Random random(6);
  const MadeTerrain terrain = made_terrain(random, 9);
  for (const double roll : {0.0, 10.0, 90.0, -30.0}) {
    ViewRequest request;
    request.roll = Angle::degrees(roll);
    const View view = place_view(request, terrain.shape(), 0.7);
    const Vec2 foot = picture_of(view, view.look_at_m);
    const Vec2 pole = picture_of(view, view.look_at_m + Vec3{0, 0, 1}) - foot;
    const double clockwise = std::atan2(pole.x, pole.y) * 180 / std::numbers::pi;
    CHECK(std::abs(clockwise - roll) <= 1e-9);
  }
}

TEST_CASE("a plan from straight above is the map, north up") {
  Random random(8);
  const MadeTerrain terrain = made_terrain(random, 9);
  ViewRequest request;
  request.projection = Projection::orthographic;
  request.from_elevation = Angle::degrees(90);
  const View view = place_view(request, terrain.shape(), 0.7);
  const Vec2 first = picture_of(view, terrain.vertices[0]);
  for (const Vec3& p : terrain.vertices) {
    const Vec2 from_first = picture_of(view, p) - first;
    CHECK(std::abs(from_first.x - (p.x - terrain.vertices[0].x)) <= 1e-12);
    CHECK(std::abs(from_first.y - (p.y - terrain.vertices[0].y)) <= 1e-12);
  }
}
