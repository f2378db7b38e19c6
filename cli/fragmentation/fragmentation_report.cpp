// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/fragmentation/fragmentation_report.hpp"

#include "cli/report/measurements.hpp"
#include "measure/growth.hpp"
#include "text/aligned_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace orograph {
namespace {

using Cells = std::vector<std::string>;

const char* word_of(Occluder occluder) {
  return occluder == Occluder::surface ? "surface" : "profiles";
}

Cells cells_of(const FragmentationRow& row) {
  const auto count = [](const FragmentationRun* run, auto member) {
    return run ? std::to_string(run->*member) : std::string("-");
  };
  const auto& least = row.least;
  std::string ties = "-";
  if (least) {
    const HorizonDifferences& d = least->at_end;
    ties = fmt::format("+{} -{}", d.ties_more + d.marks, d.ties_fewer);
  }
  constexpr auto kEnd = &FragmentationRun::at_end, kMost = &FragmentationRun::at_most;
  return {name_of(row),
          std::to_string(row.occluders),
          count(row.without_collapse(), kEnd),
          std::to_string(row.collapsed.at_end),
          count(row.least_run(), kEnd),
          ties,
          count(row.without_collapse(), kMost),
          std::to_string(row.collapsed.at_most),
          count(row.least_run(), kMost),
          row.fragmented ? milliseconds(row.fragmented->seconds, 2) : "-",
          milliseconds(row.collapsed.seconds, 2),
          least ? milliseconds(least->run.seconds, 2) : "-"};
}

// What tells rows apart.
Record scene_of(const FragmentationRow& row) {
  return {{"scene", row.scene},
          {"occluder", std::string(word_of(row.occluder))},
          {"azimuth_deg", row.azimuth_deg},
          {"elevation_deg", row.elevation_deg}};
}

Record record_of(const FragmentationRow& row) {
  Record out = scene_of(row);
  const auto add = [&](const std::string& name, Value value) {
    out.emplace_back(name, std::move(value));
  };
  add("profiles", static_cast<std::uint64_t>(row.profiles));
  add("segments", row.segments);
  add("occluders", row.occluders);
  add("visible_pieces", row.visible);
  const auto add_run = [&](const std::string& name, const FragmentationRun* run) {
    add(name + "_at_end", run ? Value(run->at_end) : Value());
    add(name + "_at_most", run ? Value(run->at_most) : Value());
    add(name + "_work", run ? Value(run->work) : Value());
    add(name + "_s", run ? Value(run->seconds) : Value());
  };
  add_run("without_collapse", row.without_collapse());
  add_run("with_collapse", &row.collapsed);
  add_run("least", row.least_run());
  const auto add_found = [&](const std::string& name, const HorizonDifferences& found) {
    const auto value = [&](std::size_t n) { return row.least ? Value(std::uint64_t{n}) : Value(); };
    add(name + "_ties_more", value(found.ties_more));
    add(name + "_ties_fewer", value(found.ties_fewer));
    add(name + "_marks", value(found.marks));
    add(name + "_fragments", value(found.fragments));
    add(name + "_stretches", value(found.stretches));
    add(name + "_wrong", value(found.wrong));
    add(name + "_farthest_mm", row.least ? Value(found.farthest_mm) : Value());
  };
  add_found("end", row.least ? row.least->at_end : HorizonDifferences{});
  add_found("all", row.least ? row.least->differences : HorizonDifferences{});
  add("has_least_size", row.least ? Value(broken_promise(row).empty()) : Value());
  return out;
}

std::vector<Record> records_of(const std::vector<FragmentationRow>& rows) {
  std::vector<Record> records;
  for (const FragmentationRow& row : rows) records.push_back(record_of(row));
  return records;
}

} // namespace

std::string fragmentation_table(const std::vector<FragmentationRow>& rows) {
  std::vector<Cells> table{
      {"", "", "pieces", "at the", "end:", "", "at", "most:", "", "clip,", "ms:", ""},
      {"scene", "occluders", "without", "with", "least", "ties", "without", "with", "least",
       "without", "with", "exact"}};
  for (const FragmentationRow& row : rows) table.push_back(cells_of(row));
  return aligned_table(table);
}

std::string growth_table(const std::vector<FragmentationRow>& rows) {
  std::vector<Cells> table;
  for (const Growth& growth : growth_of(rows)) {
    const FragmentationRow& like = growth.like;
    Cells cells{fmt::format("{}{}, from {}/{}", like.scene == "terrain" ? "" : like.scene + ", ",
                            like.occluder == Occluder::surface ? "surface" : "profiles",
                            like.azimuth_deg, like.elevation_deg)};
    Cells heading{"exponents of growth with the number of profiles"};
    for (const auto& [name, exponent] : growth.exponents) {
      std::string words = name;
      std::replace(words.begin(), words.end(), '_', ' ');
      heading.push_back(words);
      cells.push_back(exponent ? fmt::format("{:.2f}", *exponent) : "-");
    }
    if (!growth.is_known()) continue;
    if (table.empty()) table.push_back(heading);
    table.push_back(cells);
  }
  return table.empty() ? "" : aligned_table(table);
}

std::string fragmentation_csv(const std::vector<FragmentationRow>& rows) {
  return csv_of(records_of(rows));
}

std::string series_csv(const std::vector<FragmentationRow>& rows) {
  std::string text = "scene,occluder,azimuth_deg,elevation_deg,profiles,after,without_collapse,"
                     "with_collapse,least\n";
  for (const FragmentationRow& row : rows) {
    const std::string scene =
        fmt::format("\"{}\",\"{}\",{},{},{}", row.scene, word_of(row.occluder), row.azimuth_deg,
                    row.elevation_deg, row.profiles);
    const auto at = [](const FragmentationRun* run, std::size_t i) {
      return run ? std::to_string(run->after[i]) : std::string();
    };
    for (std::size_t i = 0; i < row.collapsed.after.size(); ++i)
      text += fmt::format("{},{},{},{},{}\n", scene, i + 1, at(row.without_collapse(), i),
                          row.collapsed.after[i], at(row.least_run(), i));
  }
  return text;
}

std::string fragmentation_json(const std::vector<FragmentationRow>& rows,
                               const std::string& terrain) {
  std::vector<Record> growths;
  for (const Growth& growth : growth_of(rows)) {
    Record& record = growths.emplace_back(scene_of(growth.like));
    for (const auto& [name, exponent] : growth.exponents)
      record.emplace_back(name, known(exponent));
  }
  return json_of(terrain, {{"rows", records_of(rows)}, {"growth", growths}});
}

} // namespace orograph
