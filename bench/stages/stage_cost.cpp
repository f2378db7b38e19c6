// SPDX-License-Identifier: GPL-3.0-or-later
// What each stage of one view costs: nanoseconds a vertex, allocations and bytes allocated, on one
// thread. One profile a grid row, the surface hides; on a terrain that is smooth at the size of a
// cell (fractal_alps) and on one that is as steep at every size (fractal_terrain).
//
//   stage_cost [--vertices N] [OPTIONS of Google Benchmark]     1000 a side unless told otherwise
//
// What a vertex is: of the terrain for facing, of a profile as cut for cut, project and clip, a
// point on the page for all that follows.
#include "bench/grounds.hpp"
#include "bench/one_a_row.hpp"
#include "bench/stages/stages.hpp"

#include <benchmark/benchmark.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

using namespace orograph;

namespace {

struct From {
  double azimuth_deg, elevation_deg;
};
constexpr std::array kFroms{From{180, 25}, From{213, 25}, From{180, 5}};

// The latest view, and the latest stage of it: Google Benchmark calls a benchmark several times to
// find out how often to repeat it.
class Latest {
public:
  explicit Latest(int vertices) : vertices_(vertices) {}

  Stage& stage(const Ground& ground, const From& from, const NamedStage& named) {
    if (view_ && is(ground, from) && stage_name_ == named.name) return stage_;
    stage_ = {};
    if (!view_ || !is(ground, from)) {
      Grid grid = ground.made(vertices_);
      const MapSpec spec = one_profile_a_row(grid, from.azimuth_deg, from.elevation_deg);
      view_ = std::make_unique<StagedView>(std::move(grid), spec);
      ground_ = &ground;
      from_ = &from;
    }
    stage_name_ = named.name;
    stage_ = named.of(*view_);
    Meter warm;
    stage_(warm);
    return stage_;
  }

private:
  bool is(const Ground& ground, const From& from) const {
    return ground_ == &ground && from_ == &from;
  }

  int vertices_;
  const Ground* ground_ = nullptr;
  const From* from_ = nullptr;
  std::unique_ptr<StagedView> view_;
  std::string_view stage_name_;
  Stage stage_;
};

void run(benchmark::State& state, Stage& stage) {
  Meter all;
  double vertices = 0;
  for ([[maybe_unused]] auto iteration : state) {
    Meter meter;
    vertices += static_cast<double>(stage(meter));
    state.SetIterationTime(meter.seconds);
    all.seconds += meter.seconds;
    all.allocations.count += meter.allocations.count;
    all.allocations.bytes += meter.allocations.bytes;
  }
  const auto rounds = static_cast<double>(state.iterations());
  const double each = 1 / std::max(vertices, 1.0);
  const auto count = static_cast<double>(all.allocations.count),
             bytes = static_cast<double>(all.allocations.bytes);
  state.counters["vertices"] = vertices / rounds;
  state.counters["ns_a_vertex"] = 1e9 * all.seconds * each;
  state.counters["allocations"] = count / rounds;
  state.counters["bytes"] = bytes / rounds;
  state.counters["allocations_a_vertex"] = count * each;
  state.counters["bytes_a_vertex"] = bytes * each;
}

// Takes `--vertices N` out of the arguments; 0 where it is wrong.
int vertices_asked(int& argc, char** argv) {
  if (argc < 2 || std::string_view(argv[1]) != "--vertices") return 1000;
  const int vertices = argc > 2 ? std::atoi(argv[2]) : 0;
  std::rotate(argv + 1, argv + std::min(argc, 3), argv + argc);
  argc -= 2;
  return vertices >= 2 ? vertices : 0;
}

} // namespace

int main(int argc, char** argv) {
  const int vertices = vertices_asked(argc, argv);
  if (vertices == 0) {
    std::fputs("stage_cost: error: --vertices needs a number from 2 up\n", stderr);
    return 2;
  }
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  Latest latest(vertices);
  for (const Ground& ground : kGrounds)
    for (const From& from : kFroms)
      for (const NamedStage& stage : all_stages()) {
        const std::string name =
            std::string(ground.name) + "/" + std::to_string(static_cast<int>(from.azimuth_deg)) +
            "/" + std::to_string(static_cast<int>(from.elevation_deg)) + "/" + stage.name;
        benchmark::RegisterBenchmark(
            name.c_str(),
            [&](benchmark::State& state) { run(state, latest.stage(ground, from, stage)); })
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
      }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
