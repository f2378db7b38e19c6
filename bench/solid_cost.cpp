// SPDX-License-Identifier: GPL-3.0-or-later
// What solids cost: a drawing of a fractal terrain with none, and with more and more huts strewn
// over it, two instances each, in one process, in turn, the least of several rounds.
//
//   solid_cost [VERTICES [ROUNDS]]     2000 and 5 unless told otherwise
#include "bench/one_a_row.hpp"
#include "data_samples/terrains.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "solids/shapes.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>

using namespace orograph;

namespace {

// Walls and a roof: two solids each, at places that are the same everywhere (the golden ratio's and
// its square's multiples fill a square evenly).
SceneFile huts(int count, const Grid& grid) {
  SceneFile scene;
  scene.path = "huts";
  scene.solids.push_back(box({80, 60, 40}));
  scene.solids.push_back(pyramid({{-45, -35}, {45, -35}, {45, 35}, {-45, 35}}, 30.0));
  for (int i = 0; i < count; ++i) {
    const double across = std::fmod(0.5 + i * 0.7548776662466927, 1.0),
                 down = std::fmod(0.5 + i * 0.5698402909980532, 1.0);
    const Vec3 at = grid.vertex_m(1 + static_cast<int>(across * (grid.columns - 2)),
                                  1 + static_cast<int>(down * (grid.rows - 2)));
    scene.places.push_back({.part = "hut", .x = at.x, .y = at.y, .height = {}});
    const auto place = static_cast<std::size_t>(i);
    const AffineMap as_it_is{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}};
    AffineMap on_walls = as_it_is;
    on_walls.origin.z = 40;
    scene.instances.push_back({place, 0, as_it_is});
    scene.instances.push_back({place, 1, on_walls});
  }
  return scene;
}

double drawing_s(const TerrainData& terrain, const PlacedView& scene, const MapSpec& spec) {
  const auto start = std::chrono::steady_clock::now();
  draw_map(terrain, scene, spec, [](double) {});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  return took.count();
}

} // namespace

int main(int argc, char** argv) {
  const int vertices = argc > 1 ? std::atoi(argv[1]) : 2000;
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
  constexpr std::array<int, 6> kHuts{0, 1, 10, 100, 500, 1000};
  TerrainData terrain;
  terrain.surface = make_terrain(MadeTerrain::fractal_alps, vertices);
  const Grid& grid = std::get<Grid>(terrain.surface);
  for (const bool one_a_row : {false, true})
    for (const double elevation : {5.0, 25.0}) {
      MapSpec spec = one_profile_a_row(terrain.surface, 213, elevation);
      if (!one_a_row) spec.style.plan.reset();
      spec.style.layers = Style().layers;
      std::array<double, kHuts.size()> least_s;
      least_s.fill(std::numeric_limits<double>::infinity());
      std::vector<PlacedView> scenes;
      std::vector<std::shared_ptr<const SceneFile>> files;
      for (const int count : kHuts) {
        files.push_back(std::make_shared<const SceneFile>(huts(count, grid)));
        scenes.push_back(placed_view(terrain, spec, count > 0 ? files.back().get() : nullptr));
      }
      for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < kHuts.size(); ++i)
          least_s[i] = std::min(least_s[i], drawing_s(terrain, scenes[i], spec));
      std::printf("213/%g, %zu profiles: none %.1f ms", elevation, scenes[0].depths_m.size(),
                  1e3 * least_s[0]);
      for (std::size_t i = 1; i < kHuts.size(); ++i)
        std::printf("; %d huts +%.1f ms (%.2f)", kHuts[i], 1e3 * (least_s[i] - least_s[0]),
                    (least_s[i] - least_s[0]) / least_s[0]);
      std::printf("\n");
    }
}
