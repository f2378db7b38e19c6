// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/check_done.hpp"
#include "cli/sweep/record.hpp"
#include "cli/sweep/sweep.hpp"
#include "cli/sweep/tables.hpp"
#include "cli/write_text.hpp"
#include "draw/byte_sink.hpp"
#include "geometry/error.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace orograph {
namespace {

namespace fs = std::filesystem;

std::string whole_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.eof() && file.fail())
    throw Error(path.string() + " can't be read", "look at its rights");
  return text;
}

Plan plan_in(const std::string& folder) {
  if (auto plan = read_plan(folder)) return std::move(*plan);
  throw Error(folder + " holds no sweep", "give a folder that orograph sweep has filled");
}

// OUT_DIR's own plan; where it has none, that of the first shard, which is written there.
Plan open_target(const MergeSettings& settings) {
  if (auto plan = read_plan(settings.out_dir)) return std::move(*plan);
  if (settings.shard_dirs.empty()) return plan_in(settings.out_dir);
  Plan plan = plan_in(settings.shard_dirs.front());
  std::error_code error;
  fs::create_directories(fs::path(settings.out_dir) / "rows", error);
  if (error) throw write_error(settings.out_dir, error.value());
  write_text(plan.text, plan_path(settings.out_dir), false);
  return plan;
}

// The drawing first: its row says that the view is done.
void copy_views(const std::string& from, const std::string& to, const Plan& plan) {
  const SweepState there = state_of(from, plan);
  std::vector<bool> has(plan.views.size(), true);
  for (const std::size_t view : there.missing) has[view] = false;
  std::vector<std::size_t> wanted = state_of(to, plan).missing;
  for (const std::size_t view : wanted) {
    if (!has[view]) continue;
    const fs::path drawing = fs::path(from) / plan.file(view);
    if (fs::exists(drawing))
      write_text(whole_file(drawing), (fs::path(to) / plan.file(view)).string(), true);
    write_text(whole_file(record_path(from, plan, view)), record_path(to, plan, view), true);
  }
}

} // namespace

void merge(const MergeSettings& settings) {
  const Plan plan = open_target(settings);
  for (const std::string& shard : settings.shard_dirs) {
    check_same(plan_in(shard), plan, shard);
    copy_views(shard, settings.out_dir, plan);
  }
  write_tables(settings.out_dir, plan);
  check_done(settings.out_dir, plan, {}, settings.quiet);
}

} // namespace orograph
