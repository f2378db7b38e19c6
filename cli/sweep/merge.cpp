// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/say.hpp"
#include "cli/sweep/folder.hpp"
#include "cli/sweep/journal.hpp"
#include "cli/sweep/sweep.hpp"
#include "geometry/error.hpp"
#include "text/text_of_file.hpp"
#include "write/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace orograph {
namespace {

namespace fs = std::filesystem;

Plan plan_in(const std::string& folder) {
  if (auto plan = read_plan(folder)) return std::move(*plan);
  throw Error(folder + " holds no sweep", "give a folder that orograph sweep has filled");
}

// OUT_DIR's own plan; where it has none, that of the first shard, which is written there.
Plan open_target(const MergeSettings& settings) {
  if (auto plan = read_plan(settings.out_dir)) return std::move(*plan);
  if (settings.shard_dirs.empty()) return plan_in(settings.out_dir);
  Plan plan = plan_in(settings.shard_dirs.front());
  begin_folder(settings.out_dir, plan);
  return plan;
}

void copy(const std::string& from, const std::string& to) {
  if (const auto content = whole_file(from)) write_text(*content, to, true);
}

// What is drawn there and not here, and why it isn't where it is neither here nor there. The
// drawing first: its row says that the view is done.
void copy_views(const std::string& from, const std::string& to, const Plan& plan) {
  enum State { missing, failed, done };
  const auto states = [&](const std::string& folder) {
    const SweepState state = state_of(folder, plan);
    for (const std::string& path : state.corrupt) say("{} can't be read", path);
    std::vector<State> of(plan.views.size(), done);
    for (const std::size_t view : state.failed) of[view] = failed;
    for (const std::size_t view : state.missing) of[view] = missing;
    return of;
  };
  const std::vector<State> there = states(from), here = states(to);
  for (std::size_t view = 0; view < plan.views.size(); ++view) {
    if (there[view] <= here[view]) continue;
    const std::string file = plan.file(view);
    if (there[view] == done) copy((fs::path(from) / file).string(), (fs::path(to) / file).string());
    copy(record_path(from, plan, view), record_path(to, plan, view));
  }
}

} // namespace

void merge(const MergeSettings& settings) {
  const Plan plan = open_target(settings);
  refuse_links(settings.out_dir, plan);
  for (const std::string& shard : settings.shard_dirs) {
    check_same(plan_in(shard), plan, shard);
    refuse_links(shard, plan);
    copy_views(shard, settings.out_dir, plan);
  }
  // Where nothing is missing, nobody draws any more.
  if (state_of(settings.out_dir, plan).missing.empty()) remove_leftovers(settings.out_dir);
  check_done(write_tables(settings.out_dir, plan), settings.out_dir, plan, {}, settings.quiet);
}

} // namespace orograph
