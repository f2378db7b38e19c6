// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep.hpp"

#include "cli/progress.hpp"
#include "cli/render.hpp"
#include "cli/sweep/check_done.hpp"
#include "cli/sweep/draw_views.hpp"
#include "cli/sweep/folder.hpp"
#include "cli/sweep/ranks.hpp"
#include "cli/sweep/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

namespace orograph {
namespace {

// What is made once of the settings; its parts refer to each other.
struct Prepared {
  explicit Prepared(const SweepSettings& settings)
      : terrain(read_ground(settings.render)), views(settings, terrain.map),
        columns(settings, views), plan(make_plan(settings, views, columns, terrain)) {
    // In degrees each view has a frame of its own.
    if (!terrain.map.earth) facts = facts_of(terrain, settings.render.map.style.flat);
  }
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  TerrainData terrain;
  ViewList views;
  Columns columns;
  Plan plan;
  std::optional<TerrainFacts> facts;
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

  const SweepRun run{settings,          prepared->terrain, prepared->views,
                     prepared->columns, prepared->plan,    prepared->facts};
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
