// SPDX-License-Identifier: GPL-3.0-or-later
// Readers of the command's own: settings, reports, what a sweep wrote down, the command line.
#include "cli/options/option_values.hpp"
#include "cli/options/options.hpp"
#include "cli/options/settings_file.hpp"
#include "cli/report/run_report.hpp"
#include "cli/sweep/journal.hpp"
#include "tests/fuzz/scratch_file.hpp"
#include "text/number_list.hpp"
#include "text/words.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace orograph {
namespace {

std::string text_of(FuzzBytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void add_from(const std::string& path) {
  static RenderSettings settings; // nothing is stored into it
  static const Command command = render_command(settings);
  read_or_refuse([&] {
    GivenOptions given;
    add_settings(command, path, given);
    for (const auto& [name, option] : given)
      expect(name.starts_with("--") && !option.values.empty(), "an option without a value");
  });
}

// A sweep of one view with a number and a text beside the columns that each has.
Plan small_plan() {
  Plan plan;
  plan.title = plan.terrain = "dem.tif";
  plan.extension = ".svg";
  for (const char* name : {"view", "name", "file", "error", "strokes", "light"})
    plan.columns.push_back({name, "", ""});
  plan.views.push_back({"map", {}});
  return plan;
}

} // namespace

void fuzz_settings(FuzzBytes bytes) {
  add_from(scratch_file("settings.toml", bytes));
}

void fuzz_report(FuzzBytes bytes) {
  const std::string path = scratch_file("report.json", bytes);
  add_from(path);
  read_or_refuse([&] { static_cast<void>(read_view(path)); });
}

void fuzz_plan(FuzzBytes bytes) {
  scratch_file("plan.json", bytes);
  const std::string folder = scratch_folder();
  read_or_refuse([&] {
    const auto plan = read_plan(folder);
    if (!plan) return;
    expect(nlohmann::json::accept(table_json(*plan, {})), "a table that isn't JSON");
    check_same(*plan, *plan, folder);
  });
}

void fuzz_rows(FuzzBytes bytes) {
  const Plan plan = small_plan();
  static const bool has_folder =
      std::filesystem::create_directory(scratch_folder() + "/rows") || true;
  static_cast<void>(has_folder);
  scratch_file("rows/map.json", bytes);
  read_or_refuse([&] {
    const auto record = read_record(scratch_folder(), plan, 0);
    if (!record) return;
    expect(record->row.size() == plan.columns.size(), "a row of another length");
    expect(nlohmann::json::accept(record->preview), "a preview that isn't JSON");
    expect(nlohmann::json::accept(table_json(plan, {*record})), "a table that isn't JSON");
    expect(table_csv(plan, {*record}).ends_with('\n'), "a table without an end");
  });
}

void fuzz_options(FuzzBytes bytes) {
  std::vector<std::string> arguments = split(text_of(bytes), '\n');
  const std::string command = arguments.front();
  arguments.erase(arguments.begin());
  for (const std::string& argument : arguments) // files elsewhere are none of ours
    if (argument.find('/') != argument.npos && argument.find("--") == argument.npos) return;
  read_or_refuse([&] {
    if (command == "sweep")
      parse_sweep(arguments);
    else if (command == "merge")
      parse_merge(arguments);
    else if (command == "accuracy")
      parse_accuracy(arguments);
    else if (command == "fragmentation")
      parse_fragmentation(arguments);
    else if (command == "info")
      parse_info(arguments);
    else if (command == "tin")
      parse_tin(arguments);
    else if (command == "visible")
      parse_visible(arguments);
    else
      parse_render(arguments);
  });
}

void fuzz_values(FuzzBytes bytes) {
  const std::string text = text_of(bytes);
  if (const auto number = parse_number(text)) expect(std::isfinite(*number), "no number");
  static_cast<void>(parse_integer(text));
  static_cast<void>(parse_place(text));
  if (const auto box = parse_box(text))
    expect(box->width() > 0 && box->height() > 0, "a box that is empty");
  if (const auto box = parse_lonlat_box(text))
    expect(box->width() > 0 && box->width() <= 360 && box->low.y >= -90 && box->high.y <= 90,
           "a box that isn't on the earth");
  static_cast<void>(parse_azimuth_deg(text));
  if (const auto from = parse_view_from(text))
    expect(std::isfinite(from->azimuth.in_degrees()) && from->elevation.in_degrees() >= -90 &&
               from->elevation.in_degrees() <= 90,
           "a view from nowhere");
  static_cast<void>(parse_light(text));
  static_cast<void>(axonometric_view(text));
  if (const auto oblique = parse_oblique(text))
    expect(oblique->length > 0 && std::isfinite(oblique->length), "an oblique view of no length");
  static_cast<void>(parse_spacing(text));
  if (const auto widths = parse_pen_width(text))
    expect(widths->least_mm > 0 && widths->least_mm <= widths->greatest_mm, "pens without a width");
  if (const auto metres = parse_metres(text)) expect(*metres >= 0, "a negative length");
  if (const auto heights = parse_heights(text))
    expect(!heights->values.empty(), "heights without one");
  if (const auto arc = parse_arc_deg(text)) expect(std::isfinite(*arc) && *arc >= 0, "no arc");
  if (const auto page = parse_page_size(text))
    expect(page->width_mm >= 1 && page->width_mm <= 10000, "a page of no size");
  static_cast<void>(parse_sheets(text));
  if (const auto scale = parse_scale(text)) expect(*scale > 0, "a scale of nothing");
  read_or_refuse([&] {
    // Up to ten million numbers are a list: here a few.
    if (text.find(':') == text.npos)
      expect(!parse_number_list("--azimuth", text, parse_azimuth_deg).empty(), "a list of nothing");
  });
}

} // namespace orograph
