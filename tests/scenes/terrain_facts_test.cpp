// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a terrain does for all its views.
#include "placing/placed_view.hpp"
#include "profiles/cut_surface.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/random_tin_scene.hpp"
#include "tests/support/random.hpp"

#include <exception>
#include <memory>

namespace orograph::terrain_facts_test {
namespace {

void check_same(const PlacedView& a, const PlacedView& b) {
  CHECK(a.view.window.low == b.view.window.low);
  CHECK(a.view.window.high == b.view.window.high);
  CHECK(a.view.distance_m == b.view.distance_m);
  CHECK(a.to_page.m == b.to_page.m);
  CHECK(a.depths_m == b.depths_m);
  CHECK(a.cell_m == b.cell_m);
  CHECK(a.border.size() == b.border.size());
  CHECK(a.level.shores == b.level.shores);
}

void check_views(const TerrainData& terrain, MapSpec spec) {
  TerrainForViews for_views(std::make_shared<const TerrainData>(terrain));
  for (const double azimuth_deg : {0.0, 110.0, 235.0}) {
    spec.view.from_azimuth = Angle::degrees(azimuth_deg);
    try {
      const TerrainOfView known(for_views, spec.view), alone(terrain, spec.view);
      const PlacedView scene = placed_view(known, spec);
      check_same(scene, placed_view(alone, spec));
      const SurfaceCutter cutter(known->surface, scene.view, scene.level.triangles,
                                 scene.for_cutters);
      CHECK(scene.nearest_m == cutter.nearest_m());
      CHECK(scene.farthest_m == cutter.farthest_m());
    } catch (const std::exception& error) {
      CHECK_THROWS_WITH(placed_view(TerrainOfView(terrain, spec.view), spec), error.what());
    }
  }
}

} // namespace

TEST_CASE("facts of a terrain place each view as if it were the only one") {
  for (std::uint64_t seed = 1; seed <= last_seed(40); ++seed) {
    INFO("seed " << seed);
    const RandomScene of_grid = random_scene(seed);
    check_views(of_grid.terrain, of_grid.spec);
    const RandomTinScene of_tin = random_tin_scene(seed);
    check_views(of_tin.terrain, of_tin.spec);
  }
}

} // namespace orograph::terrain_facts_test
