// SPDX-License-Identifier: GPL-3.0-or-later
// How the time of one view grows with the terrain: seconds by stage on fractal terrains of several
// sizes, one profile a grid row, the surface hides, one thread; and the exponent of the power law
// through them, by least squares of log seconds over log cells.
//
// Reading and writing aren't in it: placing, facing, cut, project, clip and layout of a terrain
// that is in memory. Heights aren't exaggerated, since what is chosen by default depends on the
// size. The least of several rounds.
//
//   growth [--csv FILE] [SIDE...]     500 1000 2000 4000 8000 vertices unless told otherwise
#include "cli/draw_scene.hpp"
#include "cli/scene.hpp"
#include "cli/stopwatch.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

#include "bench/csv_file.hpp"
#include "bench/exponent.hpp"
#include "bench/one_a_row.hpp"
#include "bench/scenes.hpp"

using namespace orograph;

namespace {

struct From {
  double azimuth_deg, elevation_deg;
};
constexpr std::array kFroms{From{180, 5}, From{213, 5}, From{180, 60}, From{213, 60}};

// Views are repeated so often, and so long: on small terrains they take but some milliseconds.
constexpr int kLeastRounds = 3;
constexpr double kLeast_s = 0.5;

// Seconds: placing first, then those of SecondsReport, then their sum.
constexpr std::array kStages{"place", "facing", "cut", "project", "clip", "layout", "whole"};
using Seconds = std::array<double, kStages.size()>;

struct Drawn {
  Seconds seconds;
  std::size_t profiles;
  CountsReport counts;
};

Drawn draw(const Terrain& terrain, const From& from) {
  RenderSettings settings =
      one_profile_a_row(terrain.surface, from.azimuth_deg, from.elevation_deg);
  settings.exaggeration = 1;
  double place_s = 0, whole_s = 0;
  Stopwatch watch, all;
  const Scene scene = place_scene(terrain, settings);
  watch.mark(place_s);
  const DrawnScene drawn = draw_scene(terrain, scene, settings, [](double) {});
  all.mark(whole_s);
  const SecondsReport& s = drawn.seconds;
  return {{place_s, s.facing, s.cut, s.project, s.clip, s.layout, whole_s},
          scene.depths_m.size(),
          drawn.counts};
}

// The quickest of several rounds, as a whole.
Drawn quickest(const Terrain& terrain, const From& from) {
  Drawn best;
  best.seconds.back() = std::numeric_limits<double>::infinity();
  double spent_s = 0;
  for (int round = 0; round < kLeastRounds || spent_s < kLeast_s; ++round) {
    const Drawn view = draw(terrain, from);
    spent_s += view.seconds.back();
    if (view.seconds.back() < best.seconds.back()) best = view;
  }
  return best;
}

std::string joined(const Seconds& values, const char* separator, const char* format) {
  std::string text;
  for (const double value : values) text += separator + fmt::format(fmt::runtime(format), value);
  return text;
}

struct Curve {
  std::array<std::vector<SizeAndTime>, kStages.size()> by_stage;
};

void measure(int side, std::array<Curve, kFroms.size()>& curves, CsvFile& csv) {
  Terrain terrain;
  terrain.surface = fractal_terrain(side);
  const double cells = (side - 1.0) * (side - 1.0);
  for (std::size_t i = 0; i < kFroms.size(); ++i) {
    const auto& [azimuth_deg, elevation_deg] = kFroms[i];
    const Drawn view = quickest(terrain, kFroms[i]);
    for (std::size_t k = 0; k < kStages.size(); ++k)
      curves[i].by_stage[k].push_back({cells, view.seconds[k]});
    fmt::print("{:5}  {:3}/{:<2} {:9} {:11} {:9}  {}  {:7.1f}\n", side, azimuth_deg, elevation_deg,
               view.profiles, view.counts.cut_vertices, view.counts.points,
               joined(view.seconds, " ", "{:8.4f}"), 1e9 * view.seconds.back() / cells);
    std::fflush(stdout);
    csv.add(fmt::format("{},{},{},{},{},{}{}", side, azimuth_deg, elevation_deg, view.profiles,
                        view.counts.cut_vertices, view.counts.points,
                        joined(view.seconds, ",", "{:.6f}")));
  }
}

} // namespace

int main(int argc, char** argv) {
  const std::string path = csv_asked(argc, argv);
  std::vector<int> sides;
  for (int i = 1; i < argc; ++i) sides.push_back(std::atoi(argv[i]));
  for (const int side : sides)
    if (side < 2) return std::fputs("usage: growth [--csv FILE] [SIDE...]\n", stderr), 2;
  if (sides.empty()) sides = {500, 1000, 2000, 4000, 8000};

  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  std::string header;
  for (const char* stage : kStages) header += fmt::format(",{}_s", stage);
  CsvFile csv(path, "side,azimuth_deg,elevation_deg,profiles,cut_vertices,points" + header);
  fmt::print(" side  from    profiles    vertices    points  ");
  for (const char* stage : kStages) fmt::print(" {:>8}", stage);
  fmt::print(" s, ns a cell\n");
  std::array<Curve, kFroms.size()> curves;
  for (const int side : sides) measure(side, curves, csv);
  for (std::size_t i = 0; i < kFroms.size(); ++i) {
    Seconds exponents;
    for (std::size_t k = 0; k < kStages.size(); ++k)
      exponents[k] = growth_exponent(curves[i].by_stage[k]);
    const auto& [azimuth_deg, elevation_deg] = kFroms[i];
    fmt::print("exponent {:3}/{:<2} {:29}  {}\n", azimuth_deg, elevation_deg, "",
               joined(exponents, " ", "{:8.3f}"));
    csv.add(fmt::format("exponent,{},{},,,{}", azimuth_deg, elevation_deg,
                        joined(exponents, ",", "{:.4f}")));
  }
}
