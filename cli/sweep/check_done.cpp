// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/check_done.hpp"

#include "cli/sweep/record.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace orograph {
namespace {

std::vector<std::size_t> of_shard(std::vector<std::size_t> views, const Shard& shard) {
  std::erase_if(views, [&](std::size_t view) { return !shard.holds(view); });
  return views;
}

std::string reason(const std::string& out_dir, const Plan& plan, std::size_t view) {
  const auto record = read_record(out_dir, plan, view);
  return record ? std::get<std::string>(record->row[kErrorColumn]) : "no row";
}

} // namespace

void check_done(const SweepState& state, const std::string& out_dir, const Plan& plan,
                const Shard& shard, bool quiet) {
  const auto failed = of_shard(state.failed, shard), missing = of_shard(state.missing, shard);
  const std::size_t all = shard.size(plan.views.size());
  if (!missing.empty())
    throw Error(fmt::format("{} of {} views are missing in {}, '{}' among them", missing.size(),
                            all, out_dir, plan.views[missing.front()].name),
                "draw them with orograph sweep --resume, then merge");
  if (!failed.empty())
    throw Error(fmt::format("{} of {} views failed, the others are drawn; '{}' failed with: {}",
                            failed.size(), all, plan.views[failed.front()].name,
                            reason(out_dir, plan, failed.front())),
                "the column error of the table tells of each");
  if (quiet) return;
  if (shard.count == 1)
    fmt::print(stderr, "orograph: {} views; open {}/index.html to see them\n", all, out_dir);
  else
    fmt::print(stderr, "orograph: {} views of shard {}/{}; orograph merge {} makes the tables\n",
               all, shard.index, shard.count, out_dir);
}

} // namespace orograph
