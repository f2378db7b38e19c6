// SPDX-License-Identifier: GPL-3.0-or-later
// How the time of one view grows with the terrain: seconds by stage on both grounds in several
// sizes, one profile a grid row, the surface hides, one thread; and the exponent of the power law
// through them, by least squares of log seconds over log cells. Where one size doesn't lie on it,
// the nanoseconds a cell tell.
//
// Reading and writing aren't in it: placing, facing, cut, project, clip and layout of a terrain
// that is in memory. Heights aren't exaggerated, since what is chosen by default depends on the
// size. The least of several rounds. Of the whole also the seconds of processor, which others on
// the machine disturb less.
//
//   growth [--csv FILE] [SIDE...]     500 1000 2000 4000 8000 vertices unless told otherwise
#include "bench/csv_file.hpp"
#include "bench/exponent.hpp"
#include "bench/grounds.hpp"
#include "bench/one_a_row.hpp"
#include "hidden_lines/instruments.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

using namespace orograph;

namespace {

struct From {
  double azimuth_deg, elevation_deg;
};
constexpr std::array kFroms{From{180, 5}, From{213, 5}, From{180, 60}, From{213, 60}};

// Views are repeated so often, and so long: on small terrains they take but some milliseconds.
// Those that take longer than a disturbance does are drawn twice.
constexpr int kRounds = 3;
constexpr double kLeast_s = 0.5, kLong_s = 10;

// Seconds: placing first, then those of StageSeconds, then all of it, by the clock and by the
// processor.
constexpr std::array kStages{"place", "facing", "cut",   "project",
                             "clip",  "layout", "whole", "processor"};
using Seconds = std::array<double, kStages.size()>;

struct Drawn {
  Seconds seconds;
  std::size_t profiles;
  Counts counts;
};

// Of this thread, which does all the work.
double processor_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Drawn draw(const TerrainData& terrain, const From& from) {
  MapSpec spec = one_profile_a_row(terrain.surface, from.azimuth_deg, from.elevation_deg);
  spec.view.exaggeration = 1;
  double place_s = 0, whole_s = 0;
  const double begin_s = processor_s();
  Stopwatch watch, all;
  const PlacedView scene = placed_view(terrain, spec);
  watch.mark(place_s);
  const Map drawn = draw_map(terrain, scene, spec, [](double) {});
  all.mark(whole_s);
  const StageSeconds& s = drawn.facts.seconds;
  return {{place_s, s.facing, s.cut, s.project, s.clip, s.layout, whole_s, processor_s() - begin_s},
          scene.depths_m.size(),
          drawn.facts.counts};
}

// The quickest of several rounds, as a whole.
Drawn quickest(const TerrainData& terrain, const From& from) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  Drawn best;
  best.seconds.back() = std::numeric_limits<double>::infinity();
  double spent_s = 0;
  for (int round = 0; round < 2 || (round < kRounds && spent_s < kLong_s) || spent_s < kLeast_s;
       ++round) {
    const Drawn drawn = draw(terrain, from);
    spent_s += drawn.seconds.back();
    if (drawn.seconds.back() < best.seconds.back()) best = drawn;
  }
  return best;
}

std::string joined(const Seconds& values, const char* separator, const char* format) {
  std::string text;
  for (const double value : values) text += separator + fmt::format(fmt::runtime(format), value);
  return text;
}

using Curve = std::array<std::vector<SizeAndTime>, kStages.size()>; // by stage

// One ground in all sizes, from all sides.
void measure(const Ground& ground, const std::vector<int>& sides, CsvFile& csv) {
  fmt::print("{}\n side  from   profiles    vertices    points  ", ground.name);
  for (const char* stage : kStages) fmt::print(" {:>9}", stage);
  fmt::print(" s; ns a cell\n");
  std::array<Curve, kFroms.size()> curves;
  for (const int side : sides) {
    TerrainData terrain;
    terrain.surface = ground.made(side);
    const double cells = (side - 1.0) * (side - 1.0);
    for (std::size_t i = 0; i < kFroms.size(); ++i) {
      const auto& [azimuth_deg, elevation_deg] = kFroms[i];
      const auto [seconds, profiles, counts] = quickest(terrain, kFroms[i]);
      for (std::size_t k = 0; k < kStages.size(); ++k) curves[i][k].push_back({cells, seconds[k]});
      fmt::print("{:5}  {:3}/{:<2} {:9} {:11} {:9}  {}    {:.1f}\n", side, azimuth_deg,
                 elevation_deg, profiles, counts.cut_vertices, counts.points,
                 joined(seconds, " ", "{:9.4f}"), 1e9 * seconds.back() / cells);
      std::fflush(stdout);
      csv.add(fmt::format("{},{},{},{},{},{},{}{}", ground.name, side, azimuth_deg, elevation_deg,
                          profiles, counts.cut_vertices, counts.points,
                          joined(seconds, ",", "{:.6f}")));
    }
  }
  for (std::size_t i = 0; i < kFroms.size(); ++i) {
    Seconds exponents;
    for (std::size_t k = 0; k < kStages.size(); ++k) exponents[k] = growth_exponent(curves[i][k]);
    const auto& [azimuth_deg, elevation_deg] = kFroms[i];
    fmt::print("exponent {:3}/{:<2} {:29}  {}\n", azimuth_deg, elevation_deg, "",
               joined(exponents, " ", "{:9.3f}"));
    csv.add(fmt::format("{},exponent,{},{},,,{}", ground.name, azimuth_deg, elevation_deg,
                        joined(exponents, ",", "{:.4f}")));
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
  std::string header = "terrain,side,azimuth_deg,elevation_deg,profiles,cut_vertices,points";
  for (const char* stage : kStages) header += fmt::format(",{}_s", stage);
  CsvFile csv(path, header);
  for (const Ground& ground : kGrounds) measure(ground, sides, csv);
}
