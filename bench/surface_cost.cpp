// SPDX-License-Identifier: GPL-3.0-or-later
// What exact visibility costs: facing, cutting and clipping with the surface as occluder, over the
// same with the drawn profiles as occluders. One profile a grid row on a fractal terrain, both in
// one process, in turn, the least of several rounds.
//
//   surface_cost [VERTICES [ROUNDS]]     2000 and 5 unless told otherwise
#include "bench/one_a_row.hpp"
#include "data_samples/terrains.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "profiles/silhouettes.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>

using namespace orograph;

namespace {

struct Cost {
  double facing_s, cut_s, project_s, clip_s;
  double sum_s() const { return facing_s + cut_s + project_s + clip_s; }
};

Cost least(const Cost& a, const Cost& b) {
  return a.sum_s() <= b.sum_s() ? a : b;
}

Cost run(const TerrainData& terrain, const PlacedView& scene, MapSpec spec, Occluder occluder) {
  spec.style.occluder = occluder;
  const StageSeconds s = draw_map(terrain, scene, spec, [](double) {}).facts.seconds;
  return {s.facing, s.cut, s.project, s.clip};
}

void print(const char* name, const Cost& cost) {
  std::printf("  %-9s facing %.3f  cut %.3f  project %.3f  clip %.3f  sum %.3f s\n", name,
              cost.facing_s, cost.cut_s, cost.project_s, cost.clip_s, cost.sum_s());
}

} // namespace

int main(int argc, char** argv) {
  const int vertices = argc > 1 ? std::atoi(argv[1]) : 2000;
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
  TerrainData terrain;
  terrain.surface = make_terrain(MadeTerrain::fractal_alps, vertices);
  for (const double elevation : {5.0, 20.0})
    for (const double azimuth : {180.0, 213.0}) {
      const MapSpec spec = one_profile_a_row(terrain.surface, azimuth, elevation);
      const PlacedView scene = placed_view(terrain, spec);
      const double infinity = std::numeric_limits<double>::infinity();
      Cost profiles{infinity, 0, 0, 0}, surface = profiles;
      double facing_s = infinity;
      for (int round = 0; round < rounds; ++round) {
        profiles = least(profiles, run(terrain, scene, spec, Occluder::profiles));
        surface = least(surface, run(terrain, scene, spec, Occluder::surface));
        const auto start = std::chrono::steady_clock::now();
        const std::size_t edges = silhouette_edges(terrain.surface, scene.view).size();
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        if (edges > 0) facing_s = std::min(facing_s, took.count());
      }
      const double triangles = 2.0 * (vertices - 1) * (vertices - 1);
      std::printf(
          "from %g/%g, %zu profiles: surface / profiles = %.2f; facing %.2f ns a triangle\n",
          azimuth, elevation, scene.depths_m.size(), surface.sum_s() / profiles.sum_s(),
          1e9 * facing_s / triangles);
      print("profiles", profiles);
      print("surface", surface);
    }
}
