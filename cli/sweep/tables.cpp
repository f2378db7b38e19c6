// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/tables.hpp"

#include "cli/sweep/page.hpp"
#include "cli/sweep/record.hpp"
#include "cli/text_file.hpp"
#include "cli/version.hpp"
#include "geometry/error.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <utility>

namespace orograph {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// More would make the page slow to open.
constexpr std::size_t kMostPreviewBytes = 32'000'000;

std::string in_folder(const std::string& out_dir, const char* name) {
  return (fs::path(out_dir) / name).string();
}

Json heading(const Plan& plan) {
  Json json{{"schema", 1},
            {"program", {{"name", "orograph"}, {"version", kVersion}, {"commit", kCommit}}},
            {"title", plan.title},
            {"terrain", plan.terrain},
            {"varied", plan.varied},
            {"crossed", plan.crossed},
            {"views_planned", plan.views.size()},
            {"columns", Json::array()}};
  for (const Column& column : plan.columns)
    json["columns"].push_back(
        {{"name", column.name}, {"unit", column.unit}, {"about", column.about}});
  return json;
}

// The heading's object with the rows as its last member, a line each.
std::string table_json(const Plan& plan, const std::vector<ViewRecord>& records) {
  std::string text = heading(plan).dump(1);
  text.erase(text.rfind("\n}"));
  text += ",\n \"views\": [";
  for (std::size_t i = 0; i < records.size(); ++i)
    text += (i > 0 ? ",\n  " : "\n  ") + json_row(plan.columns, records[i].row);
  return text + "\n ]\n}\n";
}

std::string table_csv(const Plan& plan, const std::vector<ViewRecord>& records) {
  std::vector<Cell> names;
  for (const Column& column : plan.columns) names.emplace_back(column.name);
  std::string text = csv_line(names);
  for (const ViewRecord& record : records) text += csv_line(record.row);
  return text;
}

// The previews of all rows, or, where they would be too much, of every second, fourth and so on.
class Previews {
public:
  void add(std::string preview) {
    if (previews_.size() % every_ != 0) preview = kNone;
    bytes_ += preview.size();
    previews_.push_back(std::move(preview));
    while (bytes_ > kMostPreviewBytes && every_ < previews_.size()) {
      every_ *= 2;
      for (std::size_t i = every_ / 2; i < previews_.size(); i += every_) {
        bytes_ -= previews_[i].size() - kNone.size();
        previews_[i] = kNone;
      }
    }
  }
  std::string json() const {
    std::string text = "[";
    for (const std::string& preview : previews_) {
      if (text.size() > 1) text += ",\n";
      text += preview;
    }
    return text + "]";
  }

private:
  inline static const std::string kNone = "null";
  std::vector<std::string> previews_;
  std::size_t bytes_ = 0, every_ = 1;
};

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

} // namespace

SweepState state_of(const std::string& out_dir, const Plan& plan) {
  return read_records(out_dir, plan, [](ViewRecord&&) {});
}

SweepState write_tables(const std::string& out_dir, const Plan& plan) {
  std::vector<ViewRecord> records;
  Previews previews;
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

} // namespace orograph
