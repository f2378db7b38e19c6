// SPDX-License-Identifier: GPL-3.0-or-later
// What the ellipsoid costs: a drawing of a fractal terrain in degrees (a tile of one degree at 45
// degrees north), over that of the same heights in metres, in cells as large. All that follows
// reading, with the profiles that `render` plans by default; both in one process, in turn, the
// least of several rounds.
//
//   degree_cost [VERTICES [ROUNDS]]     3600 and 5 unless told otherwise
#include "data_samples/terrains.hpp"
#include "dem/extent.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"
#include "write/write_drawing.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <utility>

using namespace orograph;

namespace {

struct Cost {
  double place_s, facing_s, cut_s, clip_s, rest_s;
  std::size_t profiles;
  double sum_s() const { return place_s + facing_s + cut_s + clip_s + rest_s; }
};

TerrainData in_degrees(Grid grid) {
  TerrainData terrain;
  const double step_deg = 1. / (grid.rows - 1);
  const LocalFrame frame(8.5, 45.5);
  terrain.map.earth = EarthFrame{frame, 1, 1};
  terrain.map.radii = CurvatureRadii{6.37e6, 6.39e6};
  grid.lattice = EarthLattice({8, step_deg, grid.columns, 46, -step_deg, grid.rows}, frame);
  terrain.surface = std::move(grid);
  return terrain;
}

// Cells as large as those in the middle of the tile.
TerrainData in_metres(Grid grid, const TerrainData& degrees) {
  TerrainData terrain;
  const GridSteps steps = steps_of(std::get<Grid>(degrees.surface));
  grid.lattice = PlaneLattice{{}, {length(steps.column_m), 0}, {0, -length(steps.row_m)}};
  terrain.map.radii = CurvatureRadii{6.37e6, 6.39e6};
  terrain.surface = std::move(grid);
  return terrain;
}

Cost run(TerrainData& terrain, const MapSpec& spec) {
  const auto start = std::chrono::steady_clock::now();
  stand_on_earth(terrain, spec.view);
  const PlacedView scene = placed_view(terrain, spec);
  const std::chrono::duration<double> placed = std::chrono::steady_clock::now() - start;
  const StageSeconds s = draw_map(terrain, scene, spec, [](double) {}).facts.seconds;
  return {placed.count(), s.facing, s.cut, s.clip, s.project + s.layout, scene.depths_m.size()};
}

Cost least(const Cost& a, const Cost& b) {
  return a.sum_s() <= b.sum_s() ? a : b;
}

void print(const char* name, const Cost& c) {
  std::printf("  %-8s place %.3f  facing %.3f  cut %.3f  clip %.3f  rest %.3f  sum %.3f s, "
              "%zu profiles\n",
              name, c.place_s, c.facing_s, c.cut_s, c.clip_s, c.rest_s, c.sum_s(), c.profiles);
}

} // namespace

int main(int argc, char** argv) {
  const int vertices = argc > 1 ? std::atoi(argv[1]) : 3600;
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
  TerrainData degrees = in_degrees(make_terrain(MadeTerrain::fractal_alps, vertices));
  TerrainData metres = in_metres(make_terrain(MadeTerrain::fractal_alps, vertices), degrees);
  for (const double elevation : {5.0, 25.0})
    for (const double azimuth : {180.0, 213.0}) {
      MapSpec spec;
      spec.view.from_azimuth = Angle::degrees(azimuth);
      spec.view.from_elevation = Angle::degrees(elevation);
      spec.view.exaggeration = 1;
      Cost on_plane{std::numeric_limits<double>::infinity(), 0, 0, 0, 0, 0}, on_earth = on_plane;
      for (int round = 0; round < rounds; ++round) {
        on_plane = least(on_plane, run(metres, spec));
        on_earth = least(on_earth, run(degrees, spec));
      }
      std::printf("from %g/%g: degrees / metres = %.2f\n", azimuth, elevation,
                  on_earth.sum_s() / on_plane.sum_s());
      print("metres", on_plane);
      print("degrees", on_earth);
    }
}
