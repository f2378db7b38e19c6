// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/draw_views.hpp"

#include "cli/options/named_fields.hpp"
#include "cli/render.hpp"
#include "cli/report/run_report.hpp"
#include "cli/sweep/preview.hpp"
#include "cli/sweep/record.hpp"
#include "geometry/error.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <new>

#include "map/describe_map.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"

namespace orograph {
namespace {

using Clock = std::chrono::steady_clock;

void write_failure(const SweepRun& run, std::size_t view, const std::string& why) {
  const std::string file = run.plan.file(view);
  std::error_code ignored; // of an earlier try
  std::filesystem::remove(std::filesystem::path(run.settings.out_dir) / file, ignored);
  write_record(run.settings.out_dir, run.plan, view, run.columns.row(view, file, why, nullptr),
               std::nullopt);
}

// What keeps one view from being drawn, but no other.
struct Undrawn {
  std::string why;
};

template <class Draw>
auto drawn_or_why(const Draw& draw) {
  try {
    return draw();
  } catch (const Error& error) {
    throw Undrawn{with_options(error.what())};
  } catch (const std::bad_alloc&) {
    throw Undrawn{"not enough memory"};
  }
}

} // namespace

void draw_view(const SweepRun& run, std::size_t view) {
  const auto start = Clock::now();
  RenderSettings settings = run.views.settings(view);
  const std::string file = run.plan.file(view);
  settings.output = (std::filesystem::path(run.settings.out_dir) / file).string();
  settings.write.overwrite = true; // a drawing without a row: the sweep ended between the two
  try {
    const auto terrain = drawn_or_why(
        [&] { return std::make_unique<TerrainOfView>(run.terrain, settings.map.view); });
    const PlacedView placed = drawn_or_why([&] {
      return placed_view(*terrain, settings.map, settings.solids.get(),
                         run.facts ? &*run.facts : nullptr);
    });
    GroundMeter ground(placed);
    Map map = drawn_or_why([&] {
      Map out = draw_map(**terrain, placed, settings.map, [](double) {}, {.observers = {&ground}});
      check_not_empty(out, settings);
      return out;
    });
    write_drawing(map.drawing, settings.output, settings.write);
    describe_map(map, **terrain, placed, settings.map);
    const RunReport report = run_report(map, settings);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const DrawnView facts{report, ground, seconds};
    write_record(run.settings.out_dir, run.plan, view, run.columns.row(view, file, "", &facts),
                 preview_of(map.drawing));
  } catch (const Undrawn& undrawn) {
    write_failure(run, view, undrawn.why);
  }
}

void draw_views(const SweepRun& run, int jobs, ViewQueue& queue,
                const std::function<void()>& done) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(jobs));
  tbb::task_arena arena(jobs);
  std::mutex telling;
  const auto draw_all = [&](int) {
    while (const auto view = queue.next()) {
      try {
        draw_view(run, *view);
      } catch (...) {
        queue.stop();
        throw;
      }
      const std::lock_guard lock(telling);
      done();
    }
  };
  arena.execute([&] { tbb::parallel_for(0, jobs, draw_all, tbb::simple_partitioner()); });
}

} // namespace orograph
