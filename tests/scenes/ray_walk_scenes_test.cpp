// SPDX-License-Identifier: GPL-3.0-or-later
// The whole pipeline with the surface as occluder, asked by the ray walk: nothing drawn is hidden,
// nothing visible is missing, in any layer.
#include "dem/read/read_raster.hpp"
#include "geometry/error.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/asked_scenes.hpp"
#include "tests/scenes/put_eye.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"
#include "tests/support/sample_names.hpp"

#include <cmath>

namespace orograph::ray_walk_scenes_test {
namespace {

const std::uint64_t kScenes = last_seed(500), kSampleProbes = 20 * last_seed(200);

} // namespace

TEST_CASE("the ray walk agrees with every line of made scenes", "[slow]") {
  Asked sum;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const RandomScene scene = random_scene(seed);
    CAPTURE(seed, scene.what);
    sum.add(ask(scene.terrain, scene.spec, 2000));
  }
  report("made scenes", sum);
  CHECK(sum.ties < sum.asked / 20);
}

TEST_CASE("a map without profiles is checked, too") {
  const RandomScene scene = random_scene(1);
  MapSpec spec = scene.spec;
  spec.check = 500;
  PlacedView placed = placed_view(scene.terrain, spec);
  placed.depths_m.clear();
  for (Sector& sector : placed.sectors) sector.profiles.clear();
  const Map map = draw_map(scene.terrain, placed, spec, {}, {});
  REQUIRE(map.facts.check);
  CHECK(map.facts.check->asked > 0);
  CHECK(map.facts.check->hidden == 0);
  CHECK(map.facts.check->missing == 0);
}

TEST_CASE("and with profiles along rows, columns and diagonals, through their vertices", "[slow]") {
  Asked sum;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    RandomScene scene = random_scene(seed);
    Grid& grid = grid_of(scene.terrain);
    Random random(seed + 200000);
    const bool diagonal = random.chance(0.3);
    if (diagonal)
      grid.plane().row_step_m = {grid.plane().column_step_m.y, -grid.plane().column_step_m.x};
    const Angle turn = atan2_angle(grid.plane().column_step_m.y, grid.plane().column_step_m.x);
    const int quarter = random.whole(0, 3);
    scene.spec.view.from_azimuth =
        Angle::degrees(90.0 * quarter + (diagonal ? 45 : 0) - turn.in_degrees());
    const double row_m = length(quarter % 2 ? grid.plane().column_step_m : grid.plane().row_step_m);
    // Every row, or every second; the first profile is half of the spacing behind the nearest
    // vertex, or on the next row.
    const auto rows = static_cast<double>(1 + seed % 2);
    scene.spec.style.plan = GroundSpacing{(diagonal ? std::sqrt(2.0) : rows) * row_m};
    scene.spec.view.projection =
        random.chance(0.7) ? Projection::orthographic : Projection::perspective;
    if (scene.spec.view.projection == Projection::perspective)
      scene.spec.view.from_elevation = Angle::degrees(random.between(0, 30));
    CAPTURE(seed, scene.what, diagonal, quarter);
    sum.add(ask(scene.terrain, scene.spec, 1000));
  }
  report("along rows", sum);
  // Where rounding leaves a profile a crumb beside a vertex, there is nothing to be seen.
  CHECK(sum.ties < sum.asked / 5);
}

TEST_CASE("and from an eye on the surface, on a vertex, a millimetre above it") {
  Asked sum;
  std::uint64_t refused = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    RandomScene scene = random_scene(seed);
    Random random(seed + 100000);
    put_eye(scene.spec, grid_of(scene.terrain), random);
    CAPTURE(seed, scene.what, scene.spec.view.eye_map->x, scene.spec.view.eye_map->y,
            *scene.spec.view.eye_map->z);
    try {
      sum.add(ask(scene.terrain, scene.spec, 2000));
    } catch (const Error&) {
      ++refused; // the height below the eye rounds to above it
    }
  }
  report("eyes at the surface", sum);
  WARN(refused << " views refused");
  CHECK(refused < kScenes / 10);
  // An eye on the surface is in the plane of the faces it stands on, and of all level with it.
  CHECK(sum.ties < sum.asked / 5);
}

TEST_CASE("and of the samples, from several sides", "[slow]") {
  Asked sum;
  for (const char* name : sample_names()) {
    const TerrainData terrain =
        read_raster(std::string(OROGRAPH_SOURCE_DIR "/data_samples/") + name + ".tif");
    for (int side = 0; side < 4; ++side) {
      CAPTURE(name, side);
      MapSpec spec;
      spec.view.from_azimuth = Angle::degrees(side % 2 ? 45.0 * side + 3.7 : 90.0 * side);
      spec.view.from_elevation = Angle::degrees(2 + 11 * side);
      if (side >= 2) spec.view.projection = Projection::orthographic;
      spec.style.plan = ProfileCount{40};
      sum.add(ask(terrain, spec, kSampleProbes));
    }
  }
  report("samples", sum);
  CHECK(sum.ties < sum.asked / 20);
}

} // namespace orograph::ray_walk_scenes_test
