// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ground sinks, the elevation that a framed view is seen from is above the target's own
// horizontal: the plane that touches the sunk ground there, found by stepping on it.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/view/made_terrain.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orograph::sinking_ground_test {

TEST_CASE("elevations are above the horizontal of what is looked at") {
  std::uint64_t sloping = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const MadeTerrain terrain = made_terrain(random, 12);
    const double size_m = terrain.extent.box.high.x - terrain.extent.box.low.x;
    ViewRequest request;
    request.from_azimuth = Angle::degrees(random.between(0, 360));
    request.from_elevation = Angle::degrees(random.between(2, 80));
    request.exaggeration = random.pick({1.0, 2.0});
    if (random.chance(0.3)) {
      request.distance_m = 3 * size_m;
      request.field_of_view = Angle::degrees(30);
    }
    // On a planet from ten times to a million times as large as the terrain.
    const double radius_m = size_m * std::pow(10, random.between(1, 6));
    request.drop = {random.between(0.9, 1.1) / (2 * radius_m), 1 / (2 * radius_m)};
    const View view = place_view(request, terrain.shape(), 0.7);

    const auto sunk = [&](double towards_eye_m) {
      const Vec3 at = view.look_at_m;
      const Vec2 step = -towards_eye_m * view.forward;
      return to_profile_frame(view, {at.x + step.x, at.y + step.y, at.z});
    };
    // Of a parabola the difference is exact.
    const double step_m = 0.01 * size_m;
    const double slope = (sunk(step_m).z - sunk(-step_m).z) / (2 * step_m);
    const ProfilePoint target = sunk(0);
    const double rises = std::atan2(view.eye_z_m - target.z, target.v);
    const double elevation_deg = 180 / std::numbers::pi * (rises - std::atan(slope));
    sloping += slope > 0.01;

    request.elevation_above = Horizontal::of_eye;
    CHECK(place_view(request, terrain.shape(), 0.7).elevation == request.from_elevation);
    request.elevation_above = Horizontal::of_target;

    // The last step that moves it does so by less than a hundredth of that.
    CHECK(std::abs(elevation_deg - request.from_elevation.in_degrees()) < 1e-3);
    CHECK(std::abs(elevation_deg + 180 / std::numbers::pi * std::atan(slope) -
                   view.elevation.in_degrees()) < 1e-9);
  }
  CHECK(sloping > last_seed(200) / 10);
}

namespace {

// So long that of two groups of its blocks one is 256 vertices long, and its corner sinks by far
// more than that of the other, and than the ground rises.
MadeTerrain flat_strip(Random& random) {
  MadeTerrain terrain;
  terrain.grid = std::make_unique<Grid>();
  Grid& grid = *terrain.grid;
  grid.columns = 300;
  grid.rows = random.whole(20, 60);
  grid.plane().column_step_m = {30, 0};
  grid.plane().row_step_m = {0, -30};
  std::vector<float> heights(grid.size());
  for (float& height : heights) height = static_cast<float>(random.between(0, 1));
  grid.heights_m = Heights<float>(std::move(heights));
  terrain.extent = extent_of(grid);
  for (const auto& [from, to] : outline_by_triangles(grid))
    terrain.outline.push_back({vertex_m(grid, from), vertex_m(grid, to)});
  for (std::uint32_t i = 0; i < grid.size(); ++i) terrain.vertices.push_back(vertex_m(grid, i));
  return terrain;
}

} // namespace

// By looking at every vertex.
TEST_CASE("the window of sinking ground is its picture's box") {
  std::uint64_t framed = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(100); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const MadeTerrain terrain = random.chance(0.5) ? made_terrain(random, 70) : flat_strip(random);
    const double size_m = terrain.extent.box.high.x - terrain.extent.box.low.x;
    ViewRequest request;
    request.from_azimuth =
        Angle::degrees(random.pick({random.between(0, 360), 180 + random.between(-3, 3)}));
    request.from_elevation = Angle::degrees(random.between(2, 80));
    request.roll = Angle::degrees(random.pick({90.0, 180.0, random.between(-180, 180)}));
    const double radius_m = size_m * std::pow(10, random.between(0.5, 1.5));
    request.drop = {random.between(0.5, 2) / (2 * radius_m), 1 / (2 * radius_m)};
    if (random.chance(0.1)) request.drop = {-request.drop.per_north, -request.drop.per_east};
    request.both_sides = true;
    std::optional<View> view;
    try {
      view = place_view(request, terrain.shape(), 0.7);
    } catch (const Error&) { // part of it is beside the eye
      continue;
    }
    ++framed;
    Box2 box;
    for (const Vec3& p : terrain.vertices) box.include(picture_of(*view, p));
    const double tolerance = 1e-12 * std::max(1.0, largest(box.high));
    CHECK(std::abs(view->window.low.x - box.low.x) <= tolerance);
    CHECK(std::abs(view->window.low.y - box.low.y) <= tolerance);
    CHECK(std::abs(view->window.high.x - box.high.x) <= tolerance);
    CHECK(std::abs(view->window.high.y - box.high.y) <= tolerance);
  }
  CHECK(framed > enough(80));
}

} // namespace orograph::sinking_ground_test
