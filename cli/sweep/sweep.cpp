// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep.hpp"

#include "cli/finish_drawing.hpp"
#include "cli/options/named_fields.hpp"
#include "cli/progress.hpp"
#include "cli/render.hpp"
#include "cli/report/run_report.hpp"
#include "cli/sweep/columns.hpp"
#include "cli/sweep/folder.hpp"
#include "cli/sweep/journal.hpp"
#include "cli/sweep/ranks.hpp"
#include "cli/tell_map.hpp"
#include "geometry/error.hpp"
#include "map/describe_map.hpp"
#include "map/draw_level.hpp"
#include "map/name_places.hpp"
#include "placing/grounds.hpp"
#include "placing/level_of_detail.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <thread>

namespace orograph {
namespace {

// What all views share.
struct SweepRun {
  const SweepSettings& settings;
  Grounds& grounds;
  const ViewList& views;
  const Columns& columns;
  const Plan& plan;
};

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

// Draws a view: writes its drawing, and then its row. A view that can't be drawn has a row with
// the reason. Throws Error where something can't be written.
void draw_view(const SweepRun& run, std::size_t view) {
  const auto start = Clock::now();
  RenderSettings settings = run.views.settings(view);
  const std::string file = run.plan.file(view);
  settings.output = (std::filesystem::path(run.settings.out_dir) / file).string();
  settings.write.overwrite = true; // a drawing without a row: the sweep ended between the two
  try {
    const std::shared_ptr<Ground> ground =
        drawn_or_why([&] { return run.grounds.of(settings.map); });
    const Overlay* const names = ground->names.empty() ? nullptr : &ground->names.front();
    settings.map = with_room_for_names(settings.map, names);
    const auto terrain = drawn_or_why(
        [&] { return std::make_unique<TerrainOfView>(ground->terrain, settings.map.view); });
    std::optional<LevelOfDetail> level;
    PlacedView placed = drawn_or_why([&] {
      level = choose_level(*terrain, settings.map, settings.solids.get());
      return placed_view(*terrain, settings.map, settings.solids.get());
    });
    placed.overlays = ground->overlays;
    placed.names = names;
    GroundMeter meter(placed);
    Map map = drawn_or_why([&] {
      Map out =
          draw_level(*terrain, placed, settings.map, level, [](double) {}, {.observers = {&meter}});
      check_not_empty(out, settings.map.view, stands_on_nothing(settings));
      finish_drawing(out, settings);
      return out;
    });
    write_drawing(map.drawing, settings.output, settings.write);
    describe_map(map, *terrain, placed, settings.map);
    const RunReport report = run_report(map, settings);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const DrawnView facts{report, meter, seconds};
    write_record(run.settings.out_dir, run.plan, view, run.columns.row(view, file, "", &facts),
                 preview_of(map.drawing));
  } catch (const Undrawn& undrawn) {
    write_failure(run, view, undrawn.why);
  }
}

// Draws views, `jobs` at a time, until the queue is empty; `done` is called after each, by one
// thread at a time. The first Error that a view throws stops the queue and is thrown when the
// others at work have ended. Memory: what the drawing of a view takes, `jobs` times.
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

// Of a sweep round the terrain; none where eyes are given, and where no view can be chosen.
std::optional<ChosenDirection> chosen_direction(Ground& ground, const ViewList& views) {
  const bool goes_round = std::ranges::any_of(views.axes(), [](const Axis& axis) {
    return axis.values.size() > 1 &&
           (axis.parameter == Parameter::azimuth || axis.parameter == Parameter::elevation);
  });
  RenderSettings settings = views.settings(0);
  if (!goes_round || settings.map.view.has_eye()) return std::nullopt;
  settings.map.view.from_auto = true;
  try {
    const TerrainOfView of_view(ground.terrain, settings.map.view);
    const auto placed = placed_view(of_view, settings.map, settings.solids.get());
    if (!placed.chosen_view) return std::nullopt;
    return ChosenDirection{placed.chosen_view->azimuth.in_degrees(),
                           placed.chosen_view->elevation.in_degrees()};
  } catch (const Error&) { // which its views tell, each for itself
    return std::nullopt;
  }
}

// What is made once of the settings; its parts refer to each other.
struct Prepared {
  explicit Prepared(const SweepSettings& settings)
      : grounds(settings.render), first(grounds.before_views(settings.render.map)),
        views(settings, first->terrain.whole().map), columns(settings, views),
        plan(make_plan(settings, views, columns, first->terrain.whole(),
                       chosen_direction(*first, views))) {}
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  Grounds grounds;
  std::shared_ptr<Ground> first;
  ViewList views;
  Columns columns;
  Plan plan;
};

int jobs_of(const SweepSettings& settings, const Ranks& ranks) {
  if (settings.jobs > 0) return settings.jobs;
  if (ranks.size() > 1) return 1;
  return static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
}

} // namespace

void sweep(const SweepSettings& settings) {
  Ranks ranks;
  const bool first = ranks.rank() == 0;
  const auto prepared = ranks.together([&] { return std::make_unique<Prepared>(settings); });
  const std::vector<std::size_t> waiting = ranks.together(
      [&] { return first ? open_folder(settings, prepared->plan) : std::vector<std::size_t>(); });

  if (first && !settings.render.quiet) {
    tell_doubts(prepared->first->terrain.whole());
    tell_notes(prepared->first->overlays);
    tell_notes(prepared->first->names);
  }
  const SweepRun run{settings, prepared->grounds, prepared->views, prepared->columns,
                     prepared->plan};
  ProgressBar bar(first && shows_progress(settings.render.quiet, settings.render.progress));
  ranks.together([&] {
    ranks.share(waiting, [&](ViewQueue& queue) {
      std::size_t done = 0;
      draw_views(run, jobs_of(settings, ranks), queue, [&] {
        bar.show(static_cast<double>(++done * static_cast<std::size_t>(ranks.size())) /
                 static_cast<double>(std::max<std::size_t>(waiting.size(), 1)));
      });
    });
    return true;
  });
  bar.finish();
  ranks.together([&] {
    if (!first) return true;
    const SweepState state = settings.shard.count == 1 ? write_tables(settings.out_dir, run.plan)
                                                       : state_of(settings.out_dir, run.plan);
    check_done(state, settings.out_dir, run.plan, settings.shard, settings.render.quiet);
    return true;
  });
}

} // namespace orograph
