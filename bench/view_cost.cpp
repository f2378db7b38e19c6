// SPDX-License-Identifier: GPL-3.0-or-later
// What one view costs: facing, and cut, project and clip in nanoseconds a cut vertex, over cutting
// alone and over reading all heights once, on one core and on two. One profile a grid row, the
// surface hides. All in one process, in turn; the least of several rounds.
//
// On two terrains: fractal_alps of the samples, which is smooth at the size of a cell, and
// mountains with slopes as steep at every size, where nearly every cell has a silhouette at 25
// degrees.
//
//   view_cost [--csv FILE] [VERTICES [ROUNDS]]     4000 and 3 unless told otherwise
#include "bench/csv_file.hpp"
#include "bench/one_a_row.hpp"
#include "bench/scenes.hpp"
#include "data_samples/terrains.hpp"
#include "hidden_lines/instruments.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "profiles/cut_surface.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

using namespace orograph;

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

template <class Run>
double seconds_of(const Run& run) {
  double seconds = 0;
  Stopwatch watch;
  run();
  watch.mark(seconds);
  return seconds;
}

struct Cost {
  double facing = kNever, cut = kNever, project = kNever, clip = kNever, layout = kNever,
         whole = kNever;
  Counts counts;

  double sum() const { return cut + project + clip; }
};

Cost draw(const TerrainData& terrain, const PlacedView& scene, const MapSpec& spec,
          std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Cost cost;
  Map drawn;
  cost.whole = seconds_of([&] { drawn = draw_map(terrain, scene, spec, [](double) {}); });
  const StageSeconds& s = drawn.facts.seconds;
  cost.facing = s.facing;
  cost.cut = s.cut;
  cost.project = s.project;
  cost.clip = s.clip;
  cost.layout = s.layout;
  cost.counts = drawn.facts.counts;
  return cost;
}

double cut_alone(const TerrainData& terrain, const PlacedView& scene) {
  const SurfaceCutter cutter(terrain.surface, scene.view, scene.level.triangles, scene.for_cutters);
  Profile profile;
  return seconds_of([&] {
    for (const double depth_m : scene.depths_m) cutter.cut(depth_m, profile);
  });
}

double read_once(const TerrainData& terrain) {
  double sum = 0;
  const double seconds = seconds_of([&] {
    std::visit(
        [&](const auto& heights) {
          float four[4] = {};
          for (std::size_t i = 0; i + 4 <= heights.size(); i += 4)
            for (std::size_t k = 0; k < 4; ++k) four[k] += static_cast<float>(heights[i + k]);
          for (const float part : four) sum += static_cast<double>(part);
        },
        std::get<Grid>(terrain.surface).heights_m);
  });
  return sum != 0 ? seconds : kNever;
}

void keep_less(Cost& least, const Cost& cost) {
  if (cost.sum() < least.sum()) {
    const double whole = std::min(least.whole, cost.whole);
    least = cost;
    least.whole = whole;
  } else {
    least.whole = std::min(least.whole, cost.whole);
  }
}

void measure(const char* name, const TerrainData& terrain, int rounds, CsvFile& csv) {
  for (const double elevation : {5.0, 25.0, 60.0})
    for (const double azimuth : {180.0, 213.0}) {
      const MapSpec spec = one_profile_a_row(terrain.surface, azimuth, elevation);
      const PlacedView scene = placed_view(terrain, spec);
      Cost one, two;
      double cut_s = kNever, read_s = kNever;
      for (int round = 0; round < rounds; ++round) {
        keep_less(one, draw(terrain, scene, spec, 1));
        keep_less(two, draw(terrain, scene, spec, 2));
        cut_s = std::min(cut_s, cut_alone(terrain, scene));
        read_s = std::min(read_s, read_once(terrain));
      }
      const double ns = 1e9 / static_cast<double>(one.counts.cut_vertices);
      std::printf(
          "from %3g/%-2g %4zu profiles, %.1fM vertices: cut %.2f + project %.2f + clip %.2f "
          "= %.2f ns a vertex; / cutting alone %.2f; / reading %.1f\n",
          azimuth, elevation, scene.depths_m.size(),
          1e-6 * static_cast<double>(one.counts.cut_vertices), one.cut * ns, one.project * ns,
          one.clip * ns, one.sum() * ns, one.sum() / cut_s, one.sum() / read_s);
      std::printf("    looked at %.2f of the ground; facing %.0f ms, layout %.0f ms, all %.0f ms; "
                  "one core / two %.2f\n",
                  one.counts.looked_at, 1e3 * one.facing, 1e3 * one.layout, 1e3 * one.whole,
                  one.whole / two.whole);
      std::fflush(stdout);
      csv.add(fmt::format("{},{},{},{},{},{},{:.4f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},"
                          "{:.6f},{:.6f},{:.6f}",
                          name, std::get<Grid>(terrain.surface).columns, azimuth, elevation,
                          scene.depths_m.size(), one.counts.cut_vertices, one.counts.looked_at,
                          one.facing, one.cut, one.project, one.clip, one.layout, one.whole,
                          two.whole, cut_s, read_s));
    }
}

} // namespace

int main(int argc, char** argv) {
  CsvFile csv(
      csv_asked(argc, argv),
      "terrain,side,azimuth_deg,elevation_deg,profiles,cut_vertices,looked_at,facing_s,cut_s,"
      "project_s,clip_s,layout_s,whole_s,two_cores_s,cutting_alone_s,reading_s");
  const int vertices = argc > 1 ? std::atoi(argv[1]) : 4000;
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 3;
  TerrainData terrain;
  std::printf("smooth: fractal_alps, %d x %d\n", vertices, vertices);
  terrain.surface = make_terrain(MadeTerrain::fractal_alps, vertices);
  measure("smooth", terrain, rounds, csv);
  std::printf("rough: fractal_terrain, %d x %d\n", vertices, vertices);
  terrain.surface = fractal_terrain(vertices);
  measure("rough", terrain, rounds, csv);
}
