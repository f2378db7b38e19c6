// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/folder.hpp"

#include "cli/say.hpp"
#include "cli/sweep/journal.hpp"
#include "cli/sweep/page.hpp"
#include "geometry/error.hpp"
#include "write/byte_sink.hpp"
#include "write/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <utility>

namespace orograph {
namespace {

namespace fs = std::filesystem;

constexpr std::initializer_list<const char*> kTables{"sweep.csv", "sweep.json", "index.html"};

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw write_error(folder.string(), error.value());
}

void remove_sweep(const std::string& out_dir, const Plan& plan) {
  const fs::path folder(out_dir);
  std::error_code ignored; // what is still there is found below
  for (std::size_t view = 0; view < plan.views.size(); ++view) {
    fs::remove(folder / plan.file(view), ignored);
    fs::remove(record_path(out_dir, plan, view), ignored);
  }
  for (const char* table : kTables) fs::remove(folder / table, ignored);
  fs::remove(plan_path(out_dir), ignored);
}

void refuse_strangers(const std::string& out_dir, const Plan& plan) {
  std::vector<std::string> names(kTables.begin(), kTables.end());
  for (std::size_t view = 0; view < plan.views.size(); ++view) names.push_back(plan.file(view));
  for (const std::string& name : names) {
    std::error_code ignored;
    const fs::path path = fs::path(out_dir) / name;
    if (fs::exists(fs::symlink_status(path, ignored)))
      throw Error(fmt::format("{} exists already, and is of no sweep", path.string()),
                  "give another folder, or move the file away");
  }
}

std::string in_folder(const std::string& out_dir, const char* name) {
  return (fs::path(out_dir) / name).string();
}

// `take` gets each record that there is.
template <class Take>
SweepState read_records(const std::string& out_dir, const Plan& plan, const Take& take) {
  SweepState state;
  std::error_code ignored;
  for (std::size_t view = 0; view < plan.views.size(); ++view) {
    try {
      auto record = read_record(out_dir, plan, view);
      if (record && record->failed)
        state.failed.push_back(view);
      else if (!record || !fs::is_regular_file(fs::path(out_dir) / plan.file(view), ignored))
        state.missing.push_back(view);
      if (record) take(std::move(*record));
    } catch (const Error&) {
      state.missing.push_back(view);
      state.corrupt.push_back(record_path(out_dir, plan, view));
    }
  }
  return state;
}

std::vector<std::size_t> of_shard(std::vector<std::size_t> views, const Shard& shard) {
  std::erase_if(views, [&](std::size_t view) { return !shard.holds(view); });
  return views;
}

std::string reason(const std::string& out_dir, const Plan& plan, std::size_t view) {
  const auto record = read_record(out_dir, plan, view);
  return record ? std::get<std::string>(record->row[kErrorColumn]) : "no row";
}

} // namespace

SweepState state_of(const std::string& out_dir, const Plan& plan) {
  return read_records(out_dir, plan, [](ViewRecord&&) {});
}

SweepState write_tables(const std::string& out_dir, const Plan& plan) {
  std::vector<ViewRecord> records;
  RowPreviews previews;
  SweepState state = read_records(out_dir, plan, [&](ViewRecord&& record) {
    previews.add(std::exchange(record.preview, {}));
    records.push_back(std::move(record));
  });
  const std::string table = table_json(plan, records);
  write_text(table_csv(plan, records), in_folder(out_dir, "sweep.csv"), true);
  write_text(table, in_folder(out_dir, "sweep.json"), true);
  write_text(sweep_page(table, previews.json()), in_folder(out_dir, "index.html"), true);
  return state;
}

void refuse_links(const std::string& out_dir, const Plan& plan) {
  const fs::path folder(out_dir);
  const auto refuse = [](const fs::path& path) {
    std::error_code ignored;
    if (fs::is_symlink(path, ignored))
      throw Error(path.string() + " is a symbolic link, which no sweep makes",
                  "put the file itself there, or remove the link and draw its view again");
  };
  refuse(folder / "rows");
  refuse(plan_path(out_dir));
  for (const char* table : kTables) refuse(folder / table);
  for (std::size_t view = 0; view < plan.views.size(); ++view) {
    refuse(folder / plan.file(view));
    refuse(record_path(out_dir, plan, view));
  }
}

void begin_folder(const std::string& out_dir, const Plan& plan) {
  try {
    refuse_strangers(out_dir, plan);
    make_folder(fs::path(out_dir) / "rows");
    write_text(plan.text, plan_path(out_dir), false);
  } catch (const Error&) {
    // Of two that begin it at a time, the second finds the first one's.
    const auto other = read_plan(out_dir);
    if (!other) throw;
    check_same(*other, plan, out_dir);
  }
}

void remove_leftovers(const std::string& out_dir) {
  std::error_code ignored;
  for (const fs::path& in : {fs::path(out_dir), fs::path(out_dir) / "rows"})
    for (const auto& entry : fs::directory_iterator(in, ignored))
      if (entry.path().filename().string().starts_with(".orograph-"))
        fs::remove(entry.path(), ignored);
}

std::vector<std::size_t> open_folder(const SweepSettings& settings, const Plan& plan) {
  const std::string& out_dir = settings.out_dir;
  std::error_code ignored;
  if (fs::exists(out_dir, ignored) && !fs::is_directory(out_dir, ignored))
    throw Error(out_dir + " is no folder", "give the folder that the sweep shall fill");
  std::optional<Plan> old_plan = read_plan(out_dir);
  if (old_plan && settings.render.write.overwrite) {
    remove_sweep(out_dir, *old_plan);
    old_plan.reset();
  }
  if (old_plan) {
    check_same(*old_plan, plan, out_dir);
    refuse_links(out_dir, plan);
  } else {
    begin_folder(out_dir, plan);
  }
  if ((settings.resume || settings.render.write.overwrite) && settings.shard.count == 1)
    remove_leftovers(out_dir);

  const SweepState state = state_of(out_dir, plan);
  for (const std::string& path : state.corrupt)
    say("{} can't be read: its view is drawn again", path);
  std::vector<std::size_t> waiting = state.missing;
  waiting.insert(waiting.end(), state.failed.begin(), state.failed.end());
  std::sort(waiting.begin(), waiting.end());
  std::erase_if(waiting, [&](std::size_t view) { return !settings.shard.holds(view); });
  const std::size_t all = settings.shard.size(plan.views.size());
  if (old_plan && !settings.resume &&
      (waiting.size() < all || settings.shard.count == 1 || !state.corrupt.empty()))
    throw Error(fmt::format("{} holds this sweep already, with {} of {} views", out_dir,
                            all - waiting.size(), all),
                "give --resume to go on with it, --overwrite to begin anew, or another folder");
  return waiting;
}

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
    say("{} views; open {}/index.html to see them", all, out_dir);
  else
    say("{} views of shard {}/{}; orograph merge {} makes the tables", all, shard.index,
        shard.count, out_dir);
}

} // namespace orograph
