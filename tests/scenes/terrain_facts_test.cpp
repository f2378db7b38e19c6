// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a terrain does for all its views.
#include "cli/scene.hpp"
#include "profiles/cut_surface.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/random_tin_scene.hpp"

#include <exception>

using namespace orograph;

namespace {

void check_same(const Scene& a, const Scene& b) {
  CHECK(a.view.window.low == b.view.window.low);
  CHECK(a.view.window.high == b.view.window.high);
  CHECK(a.view.distance_m == b.view.distance_m);
  CHECK(a.to_page.m == b.to_page.m);
  CHECK(a.depths_m == b.depths_m);
  CHECK(a.cell_m == b.cell_m);
  CHECK(a.border.size() == b.border.size());
  CHECK(a.level.shores == b.level.shores);
}

void check_views(const Terrain& terrain, RenderSettings settings) {
  const TerrainFacts facts = facts_of(terrain, settings.flat);
  for (const double azimuth_deg : {0.0, 110.0, 235.0}) {
    settings.from_azimuth = Angle::degrees(azimuth_deg);
    try {
      const Scene scene = place_scene(terrain, facts, settings);
      check_same(scene, place_scene(terrain, settings));
      const SurfaceCutter cutter(terrain.surface, scene.view, scene.level.triangles, scene.border);
      CHECK(scene.nearest_m == cutter.nearest_m());
      CHECK(scene.farthest_m == cutter.farthest_m());
    } catch (const std::exception& error) {
      CHECK_THROWS_WITH(place_scene(terrain, settings), error.what());
    }
  }
}

} // namespace

TEST_CASE("facts of a terrain place each view as if it were the only one") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    const RandomScene of_grid = random_scene(seed);
    check_views(of_grid.terrain, of_grid.settings);
    const RandomTinScene of_tin = random_tin_scene(seed);
    check_views(of_tin.terrain, of_tin.settings);
  }
}
