// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/journal.hpp"

#include "cli/report/measurements.hpp"
#include "cli/version.hpp"
#include "dem/read/asked_window.hpp"
#include "geometry/error.hpp"
#include "placing/fingerprint.hpp"
#include "text/nesting.hpp"
#include "text/text_of_file.hpp"
#include "text/words.hpp"
#include "write/output_file.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

namespace orograph {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const PathEye& eye) {
  const GivenPlace& at = eye.place;
  return {at.x, at.y, at.z ? Json(*at.z) : Json(), eye.look.in_degrees()};
}

Json json_of(const SceneFile& scene) {
  return {{"name", std::filesystem::path(scene.path).filename().string()},
          {"fingerprint", fingerprint(scene)}};
}

Json json_of(const ChosenDirection& chosen) {
  return {{"azimuth_deg", chosen.azimuth_deg}, {"elevation_deg", chosen.elevation_deg}};
}

Json json_of(const std::vector<Column>& columns) {
  Json json = Json::array();
  for (const Column& column : columns)
    json.push_back({{"name", column.name}, {"unit", column.unit}, {"about", column.about}});
  return json;
}

Json json_of(const SweepSettings& settings, const ViewList& views, const Columns& columns,
             const TerrainData& terrain, const std::optional<ChosenDirection>& chosen,
             const std::string& title) {
  Json json{
      {"schema", 1},
      {"program", {{"name", "orograph"}, {"version", kVersion}}},
      {"title", title},
      {"terrain",
       {{"name", std::filesystem::path(terrain.source).filename().string()},
        {"fingerprint", fingerprint(terrain)}}},
      {"options", settings.options},
      {"extension", "." + format_names()[static_cast<std::size_t>(settings.render.write.format)]},
      {"crossed", !settings.zipped},
      {"varied", Json::array()},
      {"columns", json_of(columns.columns())},
      {"views", Json::array()}};
  for (const Axis& axis : views.axes())
    if (axis.values.size() > 1) json["varied"].push_back(names_of(axis.parameter).column);
  for (std::size_t i = 0; i < views.size(); ++i)
    json["views"].push_back({{"name", views.name(i)}, {"values", views.values(i)}});
  if (chosen) json["chosen"] = json_of(*chosen);
  if (settings.render.solids) json["scene"] = json_of(*settings.render.solids);
  if (!views.eyes().empty()) {
    json["eyes"] = Json::array();
    for (const PathEye& eye : views.eyes()) json["eyes"].push_back(json_of(eye));
  }
  if (!settings.views.empty()) {
    json["list"] = Json::array();
    for (const NamedView& view : settings.views) json["list"].push_back(view_file_text(view.view));
  }
  return json;
}

Plan plan_of(const Json& json, std::string text) {
  Plan plan;
  plan.title = json.at("title");
  plan.terrain = json.at("terrain").at("name");
  plan.text = std::move(text);
  plan.extension = json.at("extension");
  plan.crossed = json.at("crossed");
  plan.varied = json.at("varied").get<std::vector<std::string>>();
  for (const Json& column : json.at("columns"))
    plan.columns.push_back({column.at("name"), column.at("unit"), column.at("about")});
  for (const Json& view : json.at("views"))
    plan.views.push_back({view.at("name"), view.at("values").get<std::vector<double>>()});
  if (json.contains("chosen"))
    plan.chosen = {json.at("chosen").at("azimuth_deg"), json.at("chosen").at("elevation_deg")};
  return plan;
}

// With what `check_same` looks at as well.
bool is_whole(const Json& json) {
  for (const Json& values : json.at("options"))
    for (const Json& value : values)
      if (!values.is_array() || !value.is_string()) return false;
  return json.at("options").is_object() && json.at("program").at("version").is_string();
}

// Names are removed with `--overwrite`: a plan from elsewhere mustn't reach beyond its folder.
bool names_files(const Plan& plan) {
  return plan.extension.find('/') == std::string::npos &&
         std::all_of(plan.views.begin(), plan.views.end(), [](const PlannedView& view) {
           return !view.name.empty() && view.name.find('/') == std::string::npos;
         });
}

// "--elevation 10", "no --elevation".
std::string in_words(const std::string& option, const Json& options) {
  if (!options.contains(option)) return "no " + option;
  const auto values = options.at(option).get<std::vector<std::string>>();
  return fmt::format("{} {}", option, joined(values, " "));
}

std::string scene_in_words(const Json& scene, const char* when) {
  if (!scene.is_object()) return "without a scene";
  return fmt::format("with the scene {}{}", scene.value("name", "unknown"), when);
}

constexpr auto kAnother = "give the same again, --overwrite to begin anew, or another folder";

void check_options(const Json& old_options, const Json& options, const std::string& out_dir) {
  Json all = old_options;
  all.update(options);
  for (const auto& [option, ignored] : all.items()) {
    const bool in_both = old_options.contains(option) && options.contains(option);
    if (in_both && old_options.at(option) == options.at(option)) continue;
    throw Error(fmt::format("{} holds a sweep with {}, not {}", out_dir,
                            in_words(option, old_options), in_words(option, options)),
                kAnother);
  }
}

std::string row_json(const std::vector<Column>& columns, const std::vector<Value>& row) {
  std::vector<std::string> members;
  for (std::size_t i = 0; i < columns.size(); ++i)
    members.push_back(fmt::format("\"{}\":{}", columns[i].name, json_text(row[i])));
  return fmt::format("{{{}}}", joined(members, ","));
}

Json json_of(const Preview& preview) {
  Json json{{"size_mm", {preview.width_mm, preview.height_mm}}, {"layers", Json::array()}};
  for (const PreviewLayer& layer : preview.layers) {
    json["layers"].push_back({{"name", layer.name},
                              {"pen_mm", layer.pen_mm},
                              {"grey", layer.grey},
                              {"path", layer.path}});
    if (!layer.colour.empty()) json["layers"].back()["colour"] = layer.colour;
  }
  return json;
}

std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<Value> cell_of(const Json& json) {
  if (json.is_null()) return Value();
  if (json.is_number_unsigned()) return Value(json.get<std::uint64_t>());
  if (json.is_number()) return Value(json.get<double>());
  if (json.is_string()) return Value(json.get<std::string>());
  return std::nullopt;
}

// Only where all columns are there, in their order.
std::optional<std::vector<Value>> row_of(const Json& json, const std::vector<Column>& columns) {
  if (!json.is_object() || json.size() != columns.size()) return std::nullopt;
  std::vector<Value> row;
  for (const auto& [name, value] : json.items()) {
    const auto cell = cell_of(value);
    if (!cell || name != columns[row.size()].name) return std::nullopt;
    row.push_back(*cell);
  }
  return row;
}

// One object, in two lines: what is read by itself needs no search.
constexpr auto kBeforeRow = "{\"row\":", kBetween = ",\n\"preview\":", kAfterPreview = "}\n";

struct RecordParts {
  std::string_view row, preview;
};
std::optional<RecordParts> parts_of(std::string_view text) {
  const std::size_t between = text.find(kBetween);
  if (between == std::string_view::npos || !text.starts_with(kBeforeRow) ||
      !text.ends_with(kAfterPreview))
    return std::nullopt;
  RecordParts parts{text.substr(0, between), text.substr(between)};
  parts.row.remove_prefix(std::string_view(kBeforeRow).size());
  parts.preview.remove_prefix(std::string_view(kBetween).size());
  parts.preview.remove_suffix(std::string_view(kAfterPreview).size());
  return parts;
}

std::string csv_line(const std::vector<Value>& row) {
  std::vector<std::string> values;
  for (const Value& value : row) values.push_back(csv_value(value));
  return fmt::format("{}\n", joined(values, ","));
}

Json heading(const Plan& plan) {
  Json json{{"schema", 1},
            {"program", {{"name", "orograph"}, {"version", kVersion}, {"commit", kCommit}}},
            {"title", plan.title},
            {"terrain", plan.terrain},
            {"varied", plan.varied},
            {"crossed", plan.crossed},
            {"views_planned", plan.views.size()},
            {"columns", json_of(plan.columns)}};
  if (plan.chosen) json["chosen"] = json_of(*plan.chosen);
  return json;
}

} // namespace

Plan make_plan(const SweepSettings& settings, const ViewList& views, const Columns& columns,
               const TerrainData& terrain, const std::optional<ChosenDirection>& chosen) {
  const std::string title = !settings.render.map.title.empty()
                                ? settings.render.map.title
                                : std::filesystem::path(terrain.source).filename().string();
  // Names may be in any encoding; JSON is UTF-8.
  const std::string text = json_of(settings, views, columns, terrain, chosen, title)
                               .dump(1, ' ', false, Json::error_handler_t::replace) +
                           "\n";
  return plan_of(Json::parse(text), text);
}

std::string plan_path(const std::string& out_dir) {
  return (std::filesystem::path(out_dir) / "plan.json").string();
}

std::optional<Plan> read_plan(const std::string& out_dir) {
  const std::string path = plan_path(out_dir);
  const auto text = whole_file(path);
  if (!text) return std::nullopt;
  constexpr auto kRight = "give another folder, or remove the file";
  try {
    check_json_nesting(*text, path, kRight);
    const Json json = Json::parse(*text);
    Plan plan = plan_of(json, *text);
    if (is_whole(json) && names_files(plan)) return plan;
  } catch (const nlohmann::json::exception&) { // told below
  } catch (const Error&) {                     // as well
  }
  throw Error(path + " is no plan of a sweep", kRight);
}

void check_same(const Plan& old_plan, const Plan& plan, const std::string& out_dir) {
  if (old_plan.text == plan.text) return;
  const Json a = Json::parse(old_plan.text), b = Json::parse(plan.text);
  check_options(a.at("options"), b.at("options"), out_dir);
  if (a.at("terrain") != b.at("terrain"))
    throw Error(fmt::format("{} holds a sweep of {}, which is not {} as it is now", out_dir,
                            old_plan.terrain, plan.terrain),
                kAnother);
  const Json scene_a = a.value("scene", Json()), scene_b = b.value("scene", Json());
  if (scene_a != scene_b)
    throw Error(fmt::format("{} holds a sweep {}, not {}", out_dir, scene_in_words(scene_a, ""),
                            scene_in_words(scene_b, " as it is now")),
                kAnother);
  if (a.at("program") != b.at("program"))
    throw Error(fmt::format("{} holds a sweep by another version of orograph, {}", out_dir,
                            a.at("program").value("version", "unknown")),
                kAnother);
  throw Error(fmt::format("{} holds a sweep of other views: the path or list was changed", out_dir),
              kAnother);
}

std::string record_path(const std::string& out_dir, const Plan& plan, std::size_t view) {
  return (std::filesystem::path(out_dir) / "rows" / (plan.views[view].name + ".json")).string();
}

void write_record(const std::string& out_dir, const Plan& plan, std::size_t view,
                  const std::vector<Value>& row, const std::optional<Preview>& preview) {
  write_text(kBeforeRow + row_json(plan.columns, row) + kBetween +
                 (preview ? dump(json_of(*preview)) : "null") + kAfterPreview,
             record_path(out_dir, plan, view), true);
}

std::optional<ViewRecord> read_record(const std::string& out_dir, const Plan& plan,
                                      std::size_t view) {
  const std::string path = record_path(out_dir, plan, view);
  const auto text = whole_file(path);
  if (!text) return std::nullopt;
  check_json_nesting(*text, path, "its view has to be drawn again (--resume)");
  const auto parts = parts_of(*text);
  const auto row =
      parts ? row_of(Json::parse(parts->row, nullptr, /*allow_exceptions=*/false), plan.columns)
            : std::nullopt;
  const bool failed = row && std::holds_alternative<std::string>((*row)[kErrorColumn]);
  if (!row || (*row)[kViewColumn] != Value(std::uint64_t{view}) ||
      (*row)[kNameColumn] != Value(plan.views[view].name) ||
      (!failed && (*row)[kErrorColumn] != Value()) || !Json::accept(parts->preview))
    throw Error(path + " is no row of this sweep", "its view has to be drawn again (--resume)");
  return ViewRecord{*row, std::string(parts->preview), failed};
}

// The heading's object with the rows as its last member, a line each.
std::string table_json(const Plan& plan, const std::vector<ViewRecord>& records) {
  std::string text = heading(plan).dump(1);
  text.erase(text.rfind("\n}"));
  text += ",\n \"views\": [";
  for (std::size_t i = 0; i < records.size(); ++i)
    text += (i > 0 ? ",\n  " : "\n  ") + row_json(plan.columns, records[i].row);
  return text + "\n ]\n}\n";
}

std::string table_csv(const Plan& plan, const std::vector<ViewRecord>& records) {
  std::vector<Value> names;
  for (const Column& column : plan.columns) names.emplace_back(column.name);
  std::string text = csv_line(names);
  for (const ViewRecord& record : records) text += csv_line(record.row);
  return text;
}

} // namespace orograph
