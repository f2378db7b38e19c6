// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/plan.hpp"

#include "cli/sweep/fingerprint.hpp"
#include "cli/text_file.hpp"
#include "cli/version.hpp"
#include "dem/read/asked_window.hpp"
#include "geometry/error.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

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

Json json_of(const SweepSettings& settings, const ViewList& views, const Columns& columns,
             const TerrainData& terrain, const std::string& title) {
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
      {"columns", Json::array()},
      {"views", Json::array()}};
  for (const Axis& axis : views.axes())
    if (axis.values.size() > 1) json["varied"].push_back(names_of(axis.parameter).column);
  for (const Column& column : columns.columns())
    json["columns"].push_back(
        {{"name", column.name}, {"unit", column.unit}, {"about", column.about}});
  for (std::size_t i = 0; i < views.size(); ++i)
    json["views"].push_back({{"name", views.name(i)}, {"values", views.values(i)}});
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
  return fmt::format("{} {}", option, fmt::join(values, " "));
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

} // namespace

Plan make_plan(const SweepSettings& settings, const ViewList& views, const Columns& columns,
               const TerrainData& terrain) {
  const std::string title = !settings.render.map.title.empty()
                                ? settings.render.map.title
                                : std::filesystem::path(terrain.source).filename().string();
  // Names may be in any encoding; JSON is UTF-8.
  const std::string text = json_of(settings, views, columns, terrain, title)
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
  try {
    const Json json = Json::parse(*text);
    Plan plan = plan_of(json, *text);
    if (is_whole(json) && names_files(plan)) return plan;
  } catch (const nlohmann::json::exception&) { // told below
  }
  throw Error(path + " is no plan of a sweep", "give another folder, or remove the file");
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

} // namespace orograph
