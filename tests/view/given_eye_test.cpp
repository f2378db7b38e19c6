// SPDX-License-Identifier: GPL-3.0-or-later
// Views from a given eye, and what they refuse.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/view/made_terrain.hpp"

using namespace orograph;

namespace {

MadeTerrain small_terrain() {
  Random random(2);
  return made_terrain(random, 6);
}

std::string refusal(const ViewRequest& request, const MadeTerrain& terrain, double aspect = 0.7) {
  try {
    place_view(request, terrain.shape(), aspect);
  } catch (const UsageError&) {
    return "usage error";
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

ViewRequest from_to(Vec3 eye, Vec3 target, Projection projection = Projection::perspective) {
  ViewRequest request;
  request.projection = projection;
  request.eye_m = eye;
  request.look_at_m = target;
  return request;
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("the page of a given eye shows its field, on the page's shape") {
  const MadeTerrain terrain = small_terrain();
  const Vec3 target = terrain.extent.box.centre();
  ViewRequest request = from_to(target + Vec3{300, -900, 200}, target);
  const View view = place_view(request, terrain.shape(), 0.5);
  CHECK_FALSE(view.frames_terrain);
  CHECK(std::abs(view.window.high.x - std::tan(std::numbers::pi / 12)) <= 1e-15); // 30 degrees
  CHECK(view.window.low.x == -view.window.high.x);
  CHECK(view.window.high.y == 0.5 * view.window.high.x);
  CHECK(view.window.low.y == -view.window.high.y);
  CHECK(std::abs(view.distance_m - std::hypot(300, 900, 200)) <= 1e-10);
  CHECK(std::abs(view.elevation.in_degrees() -
                 std::atan2(200, std::hypot(300, 900)) * 180 / std::numbers::pi) <= 1e-12);
  CHECK(view.depth_origin_m == Vec2{request.eye_m->x, request.eye_m->y});

  request.exaggeration = 3; // of the eye and the target too
  const View steep = place_view(request, terrain.shape(), 0.5);
  CHECK(steep.eye_z_m == 3 * request.eye_m->z);
  CHECK(std::abs(steep.distance_m - std::hypot(300, 900, 600)) <= 1e-10);
  CHECK(largest(picture_of(steep, target)) <= 1e-13);
}

TEST_CASE("distance and field together show just that field around the target") {
  const MadeTerrain terrain = small_terrain();
  ViewRequest request;
  request.distance_m = 5000;
  request.field_of_view = Angle::degrees(20);
  const View view = place_view(request, terrain.shape(), 0.7);
  CHECK_FALSE(view.frames_terrain);
  CHECK(std::abs(view.window.high.x - std::tan(std::numbers::pi / 18)) <= 1e-15);
  CHECK(largest(picture_of(view, view.look_at_m)) <= 1e-13);
  const Vec3 eye{view.depth_origin_m.x, view.depth_origin_m.y, view.eye_z_m};
  CHECK(std::abs(length(eye - view.look_at_m) - 5000) <= 1e-9);
}

TEST_CASE("an eye that can't see is refused") {
  const MadeTerrain terrain = small_terrain();
  const Vec3 centre = terrain.extent.box.centre();
  const Vec3 above = centre + Vec3{0, 0, 500}, north = centre + Vec3{0, 2000, 100};
  const auto parallel = Projection::orthographic;
  CHECK(says(refusal(from_to(centre, centre), terrain), "coincide"));
  CHECK(says(refusal(from_to(centre, centre, parallel), terrain), "coincide"));
  CHECK(says(refusal(from_to(above, above + Vec3{0, 0, 500}), terrain), "behind the eye"));
  CHECK(says(refusal(from_to(centre, above, parallel), terrain), "look up"));
  CHECK(says(refusal(from_to(centre, north, parallel), terrain), "look up"));
  CHECK(says(refusal(from_to(north, north + Vec3{0, 1000, 0}), terrain), "behind the eye"));
  CHECK(refusal(from_to(north, centre), terrain).empty());
  CHECK(refusal(from_to(above, centre), terrain).empty());
}

TEST_CASE("an eye that looks in a direction sees as a pinhole along it") {
  const MadeTerrain terrain = small_terrain();
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    ViewRequest request;
    request.exaggeration = random.pick({1.0, 2.0});
    request.roll = Angle::degrees(random.pick({0.0, random.between(-180, 180)}));
    request.field_of_view = Angle::degrees(60);
    request.look_at_m = Vec3{1, 2, 3}; // goes behind the direction
    const double azimuth = random.pick({0.0, 90.0, random.between(-400, 400)});
    const double pitch = random.pick({0.0, random.between(-80, 80)});
    request.look = LookDirection{Angle::degrees(azimuth), Angle::degrees(pitch)};
    const double a = azimuth * std::numbers::pi / 180, p = pitch * std::numbers::pi / 180;
    const Vec3 axis{std::sin(a) * std::cos(p), std::cos(a) * std::cos(p), std::sin(p)};
    // So that the terrain is ahead.
    const Vec3 ahead = 2000 * axis;
    request.eye_m =
        terrain.extent.box.centre() - Vec3{ahead.x, ahead.y, ahead.z / request.exaggeration};
    INFO("seed " << seed);
    const View view = place_view(request, terrain.shape(), 0.7);
    const Pinhole camera =
        pinhole(exaggerated(*request.eye_m, request.exaggeration), axis, request.roll.in_degrees());
    int compared = 0;
    for (const Vec3& ground : terrain.vertices) {
      const Vec3 scene = exaggerated(ground, request.exaggeration);
      if (to_profile_frame(view, ground).v < 1 || camera.along(scene) < 1) continue;
      const Vec2 found = picture_of(view, ground), expected = camera.picture(scene);
      REQUIRE(largest(found - expected) <= 1e-10 * std::max(1.0, largest(expected)));
      ++compared;
    }
    REQUIRE(compared > 0);
    CHECK(largest(picture_of(view, view.look_at_m)) <= 1e-6); // a metre ahead
    CHECK(view.distance_m == 1);
    CHECK_FALSE(view.frames_terrain);
  }
}

TEST_CASE("a direction straight up or down, or with all of the terrain behind") {
  const MadeTerrain terrain = small_terrain();
  ViewRequest request;
  request.eye_m = terrain.extent.box.centre() + Vec3{0, 0, 1000};
  request.look = LookDirection{Angle::degrees(90), Angle::degrees(-90)};
  const View down = place_view(request, terrain.shape(), 0.7);
  CHECK(down.elevation == Angle::degrees(90));
  CHECK(down.forward == Vec2{1, 0});
  request.look->pitch = Angle::degrees(90);
  CHECK(says(refusal(request, terrain), "behind the eye"));
  request.look->pitch = Angle();
  CHECK_FALSE(std::signbit(place_view(request, terrain.shape(), 0.7).elevation.in_degrees()));
}

TEST_CASE("straight down is a plan in a parallel view, north up") {
  const MadeTerrain terrain = small_terrain();
  const Vec3 centre = terrain.extent.box.centre();
  const View view = place_view(from_to(centre + Vec3{0, 0, 500}, centre, Projection::orthographic),
                               terrain.shape(), 0.7);
  CHECK(view.elevation == Angle::degrees(90));
  CHECK(view.y_per_v == 1);
  CHECK(view.y_per_z == 0);
  CHECK(view.forward == Vec2{0, 1});
  CHECK(view.frames_terrain);
}

TEST_CASE("straight down in perspective, what is farther from where the viewer stood is up") {
  const MadeTerrain terrain = small_terrain();
  const Vec3 centre = terrain.extent.box.centre();
  ViewRequest request = from_to(centre + Vec3{0, 0, 500}, centre);
  request.from_azimuth = Angle::degrees(270);
  const View view = place_view(request, terrain.shape(), 0.7);
  CHECK(view.forward == direction_of_azimuth(Angle::degrees(90)));
  const auto picture = [&](Vec3 p) {
    const Vec3 image = view.to_picture.of(project_homogeneous(view, to_profile_frame(view, p)));
    return Vec2{image.x / image.z, image.y / image.z};
  };
  CHECK(largest(picture(centre)) <= 1e-15);
  CHECK(largest(picture(centre + Vec3{50, 0, 0}) - Vec2{0, 0.1}) <= 1e-15);
  CHECK(largest(picture(centre + Vec3{-50, 0, 0}) - Vec2{0, -0.1}) <= 1e-15);
  CHECK(largest(picture(centre + Vec3{0, -50, 0}) - Vec2{0.1, 0}) <= 1e-15);
}
