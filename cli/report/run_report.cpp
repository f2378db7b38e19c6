// SPDX-License-Identifier: GPL-3.0-or-later
// The run report as JSON, written.
#include "cli/report/run_report.hpp"

#include "cli/finish_drawing.hpp"
#include "cli/render_settings.hpp"
#include "cli/report/name_report.hpp"
#include "cli/version.hpp"
#include "geometry/error.hpp"
#include "write/output_file.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace orograph {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(Vec2 p) {
  return {p.x, p.y};
}
Json json_of(Vec3 p) {
  return {p.x, p.y, p.z};
}

Json point_or_null(const std::optional<Vec3>& p) {
  return p ? json_of(*p) : Json();
}

Json json_of(const TriangulationCounts& counts) {
  return {{"points", counts.points},
          {"merged", counts.merged},
          {"greatest_merged_m", counts.greatest_merged_m},
          {"breaklines", counts.breaklines},
          {"crossings", counts.crossings},
          {"greatest_crossing_m", counts.greatest_crossing_m},
          {"outside_boundary", counts.outside},
          {"beyond_max_edge", counts.beyond_max_edge}};
}

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json name_or_null(const std::string& name) {
  return name.empty() ? Json() : Json(name);
}

Json json_of(const InputFacts& input, const std::string& scene_path) {
  return {{"paths", input.paths},
          {"crs", {{"name", input.crs_name}, {"wkt", input.crs_wkt}}},
          {"vertical_crs", name_or_null(input.vertical_crs_name)},
          {"unit", input.unit_name},
          {"unit_m", input.unit_m},
          {"unit_deg", input.unit_deg},
          {"height_unit", input.height_unit_name},
          {"height_unit_m", input.height_unit_m},
          {"surface", input.vertices  ? "tin"
                      : input.columns ? "grid"
                                      : "none"},
          {"columns", or_null(input.columns)},
          {"rows", or_null(input.rows)},
          {"column_step_m", input.column_step_m},
          {"row_step_m", input.row_step_m},
          {"vertices", or_null(input.vertices)},
          {"triangles", or_null(input.triangles)},
          {"triangulation", input.triangulation ? json_of(*input.triangulation) : Json()},
          {"surface_error_m", input.surface_error_m},
          {"scene", name_or_null(scene_path)},
          {"notes", input.notes}};
}

// The keys of view files.
Json json_of(const ViewFile& view) {
  const Box2& window = view.window_m;
  return {
      {"projection", view.projection == PhigsProjection::perspective ? "perspective" : "parallel"},
      {"vrp", json_of(view.vrp_map)},
      {"vpn", json_of(view.vpn)},
      {"vup", json_of(view.vup)},
      {"prp", json_of(view.prp_m)},
      {"window", {window.low.x, window.low.y, window.high.x, window.high.y}},
      {"front", or_null(view.front_m)},
      {"back", or_null(view.back_m)},
      {"exaggeration", view.exaggeration}};
}

Json json_of(const PanoramaFacts& panorama) {
  return {{"azimuth_from_deg", panorama.azimuth_from_deg},
          {"azimuth_to_deg", panorama.azimuth_to_deg},
          {"altitude_low_deg", panorama.altitude_low_deg},
          {"altitude_high_deg", panorama.altitude_high_deg},
          {"radius_mm", panorama.radius_mm},
          {"strips", panorama.strips}};
}

Json json_of(const ViewFacts& view) {
  Json rows = Json::array();
  for (std::size_t row = 0; row < 3; ++row)
    rows.push_back({view.homography.m[3 * row], view.homography.m[3 * row + 1],
                    view.homography.m[3 * row + 2]});
  Json json = {{"projection", view.projection},
               {"view_from_azimuth_deg", view.view_from_azimuth_deg},
               {"view_from_auto", view.view_from_auto},
               {"look_azimuth_deg", view.look_azimuth_deg},
               {"look_azimuth_true_deg", view.look_azimuth_true_deg},
               {"elevation_deg", view.elevation_deg},
               {"eye", point_or_null(view.eye)},
               {"eye_lonlat", point_or_null(view.eye_lonlat)},
               {"eye_height_m", view.eye_height_m},
               {"look_at", point_or_null(view.look_at)},
               {"look_at_lonlat", point_or_null(view.look_at_lonlat)},
               {"distance_m", view.distance_m},
               {"geodesic", view.geodesic ? Json{{"distance_m", view.geodesic->distance_m},
                                                 {"azimuth_deg", view.geodesic->azimuth_deg}}
                                          : Json()},
               {"depth_origin", json_of(view.depth_origin)},
               {"forward", json_of(view.forward)},
               {"field_of_view_deg", view.field_of_view_deg},
               {"oblique", view.oblique
                               ? Json{{"length", view.oblique->x}, {"rise_deg", view.oblique->y}}
                               : Json()},
               {"roll_deg", view.roll_deg},
               {"exaggeration", view.exaggeration},
               {"exaggeration_auto", view.exaggeration_auto},
               {"curvature",
                {{"setting", view.curvature.setting},
                 {"applied", view.curvature.applied},
                 {"on_ellipsoid", view.curvature.on_ellipsoid},
                 {"would_move_mm", view.curvature.would_move_mm},
                 {"refraction", view.curvature.refraction},
                 {"curvature_coefficient", view.curvature.curvature_coefficient},
                 {"effective_radius_m", view.curvature.effective_radius_m}}},
               {"homography", rows},
               {"phigs", json_of(view.phigs)}};
  if (view.panorama) { // which is no plane picture
    json["panorama"] = json_of(*view.panorama);
    json["phigs"] = nullptr;
  }
  return json;
}

Json json_of(const Counts& counts) {
  return {{"cut_vertices", counts.cut_vertices},
          {"segments", counts.segments},
          {"pieces_before_collapse", counts.pieces_before_collapse},
          {"pieces_after_collapse", counts.pieces_after_collapse},
          {"largest_horizon", counts.largest_horizon},
          {"strokes", counts.strokes},
          {"points", counts.points},
          {"ties", counts.ties},
          {"dropped_strokes", counts.dropped_strokes},
          {"turned_over", counts.turned_over},
          {"looked_at", counts.looked_at},
          {"solids", counts.solids},
          {"solid_edges", counts.solid_edges},
          {"draped", counts.draped},
          {"draped_in_part", counts.draped_in_part},
          {"not_draped", counts.not_draped}};
}

Json json_of(const std::vector<LayerFacts>& layers,
             const std::vector<std::optional<double>>& minutes) {
  Json list = Json::array();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const LayerFacts& layer = layers[i];
    list.push_back({{"name", layer.name},
                    {"strokes", layer.strokes},
                    {"ink_mm", layer.ink_mm},
                    {"pen_up_mm", layer.pen_up_mm},
                    {"pen_lifts", layer.pen_lifts},
                    {"pen_minutes", i < minutes.size() ? or_null(minutes[i]) : Json()}});
  }
  return list;
}

Json json_of(const std::vector<SheetFacts>& sheets) {
  Json list = Json::array();
  for (const SheetFacts& sheet : sheets)
    list.push_back({{"path", sheet.path},
                    {"strokes", sheet.strokes},
                    {"ink_mm", sheet.travel.down_mm},
                    {"pen_up_mm", sheet.travel.up_mm},
                    {"pen_lifts", sheet.travel.lifts},
                    {"pen_minutes", or_null(sheet.minutes)}});
  return list;
}

void count_sheets(RunReport& report, std::span<const Drawing> sheets,
                  const RenderSettings& settings) {
  const std::vector<std::string> names = output_names(settings);
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const PenWork one = pen_work(sheets.subspan(i, 1), settings.pen_speeds);
    report.sheets.push_back({names[i], one.strokes, one.travel(), sum_of(one.minutes)});
  }
  const PenWork all = pen_work(sheets, settings.pen_speeds);
  report.layers = all.layers;
  report.minutes_of_layers = all.minutes;
  report.counts.strokes = all.strokes;
  report.counts.points = all.points;
  const PenTravel travel = all.travel();
  report.pen_down_mm = travel.down_mm;
  report.pen_up_mm = travel.up_mm;
  report.pen_lifts = travel.lifts;
}

Json json_of(const SkylinePlace& place) {
  return {{"azimuth_deg", place.bearing.azimuth_deg},
          {"altitude_deg", place.bearing.altitude_deg},
          {"distance_m", place.bearing.distance_m},
          {"map", {place.map.x, place.map.y, place.height}},
          {"lonlat", place.lonlat ? Json{place.lonlat->x, place.lonlat->y} : Json()},
          {"at_border", place.at_border}};
}

Json json_of(const Skyline& skyline) {
  return {{"directions", skyline.directions.size()},
          {"at_border", std::ranges::count_if(skyline.directions,
                                              [](const auto& direction) {
                                                return direction.place &&
                                                       direction.place->at_border;
                                              })},
          {"most_distant", skyline.most_distant ? json_of(*skyline.most_distant) : Json()}};
}

Json json_of(const CheckCounts& check) {
  return {{"asked", check.asked},
          {"ties", check.ties},
          {"drawn_but_hidden", check.hidden},
          {"visible_but_not_drawn", check.missing}};
}

Json json_of(const CheckOfFile& check) {
  return {{"within_mm", check.within_mm},
          {"asked", check.counts.asked},
          {"ties", check.counts.ties},
          {"drawn_but_hidden", check.counts.hidden}};
}

Json json_of(const LevelOfDetail& level) {
  return {{"step", level.step},
          {"most_step", level.most_step},
          {"cell_m", level.cell_m},
          {"cell_mm", level.cell_mm},
          {"greatest_departure_m", level.greatest_m},
          {"rms_departure_m", level.rms_m},
          {"greatest_departure_mm", level.greatest_mm},
          {"summits", level.summits},
          {"summit_moved_mm", level.summit_moved_mm},
          {"summits_moved", level.summits_moved}};
}

Json json_of(const StageSeconds& seconds) {
  return {{"read", seconds.read},   {"place", seconds.place},     {"facing", seconds.facing},
          {"cut", seconds.cut},     {"project", seconds.project}, {"clip", seconds.clip},
          {"check", seconds.check}, {"layout", seconds.layout},   {"write", seconds.write},
          {"total", seconds.total}};
}

Json or_unknown(const std::optional<double>& mm) {
  return mm ? Json(*mm) : Json("unknown");
}

Json json_of(const ErrorBudget& budget) {
  return {{"level_of_detail", or_unknown(budget.level_of_detail_mm)},
          {"simplification", budget.simplification_mm},
          {"joining", budget.joining_mm},
          {"shore_smoothing", budget.shore_smoothing_mm},
          {"visibility_tolerance", budget.visibility_tolerance_mm},
          {"arithmetic", budget.arithmetic_mm},
          {"geodesy", or_unknown(budget.geodesy_mm)},
          {"rounding", budget.rounding_mm},
          {"total", or_unknown(budget.total_mm())}};
}

// What is given and what is by default, and what was chosen for this map: written out, so that
// another version that chooses otherwise draws the same.
NamedValues settings_of(const MapFacts& facts, const RenderSettings& settings) {
  NamedValues all = settings.options;
  const auto is_there = [&](const char* option) {
    return std::any_of(all.begin(), all.end(),
                       [&](const auto& entry) { return entry.first == option; });
  };
  const auto add = [&](const char* option, std::string value) {
    if (!is_there(option)) all.push_back({option, {std::move(value)}});
  };
  if (all.empty() || facts.profiles.spacing.empty()) return all;
  const Style& style = settings.map.style;
  if (!is_there("profiles")) add("spacing", facts.profiles.spacing);
  if (!settings.map.view.file) add("exaggeration", fmt::format("{}", facts.view.exaggeration));
  if (settings.map.view.projection == Projection::oblique)
    add("oblique", fmt::format("{},{}", settings.map.view.oblique.length,
                               settings.map.view.oblique.rise.in_degrees()));
  if (style.light) {
    add("light-by", style.light->by_density ? "density" : "width");
    add("haze", fmt::format("{}", style.haze_in(facts.view.eye.has_value())));
  }
  add("min-stroke", fmt::format("{}", settings.map.min_stroke_mm()));
  return all;
}

Json json_of(const NamedValues& settings) {
  Json json = Json::object();
  for (const auto& [option, values] : settings) {
    if (values.size() > 1)
      json[option] = values;
    else if (values.empty())
      json[option] = true;
    else
      json[option] = values.front();
  }
  return json;
}

} // namespace

RunReport run_report(const Map& map, const RenderSettings& settings,
                     std::span<const Drawing> sheets) {
  RunReport report;
  static_cast<MapFacts&>(report) = map.facts;
  report.error_budget.rounding_mm = rounding_mm(settings.write);
  report.path = settings.output;
  report.format = format_names()[static_cast<std::size_t>(settings.write.format)];
  report.scene_path = settings.scene_file;
  report.settings = settings_of(map.facts, settings);
  report.page = map.drawing.page;
  report.minutes_of_layers = minutes_by_layer(map.drawing, settings.pen_speeds);
  if (!sheets.empty()) count_sheets(report, sheets, settings);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  report.peak_memory_bytes =
      static_cast<std::uint64_t>(usage.ru_maxrss) * 1024; // Linux counts in KiB
  report.libraries = library_versions();
  return report;
}

std::string report_text(const RunReport& report) {
  Json json{{"schema", 1},
            {"program", {{"name", "orograph"}, {"version", kVersion}, {"commit", kCommit}}},
            {"libraries", report.libraries},
            {"input", json_of(report.input, report.scene_path)},
            {"output", {{"path", report.path}, {"format", report.format}}},
            {"settings", json_of(report.settings)},
            {"view", json_of(report.view)},
            {"page",
             {{"width_mm", report.page.width_mm},
              {"height_mm", report.page.height_mm},
              {"margin_mm", report.page.margin_mm}}},
            {"level_of_detail", report.level ? json_of(*report.level) : Json()},
            {"counts", json_of(report.counts)},
            {"layers", json_of(report.layers, report.minutes_of_layers)},
            {"pen_down_mm", report.pen_down_mm},
            {"pen_up_mm", report.pen_up_mm},
            {"pen_lifts", report.pen_lifts},
            {"pen_minutes", or_null(sum_of(report.minutes_of_layers))},
            {"sheets", report.sheets.empty() ? Json() : json_of(report.sheets)},
            {"error_budget_mm", json_of(report.error_budget)},
            {"ink_left_out_mm",
             {{"silhouette_jump", report.left_out.silhouette_jump_mm},
              {"min_stroke", report.left_out.min_stroke_mm}}},
            {"skyline", report.skyline ? json_of(*report.skyline) : Json()},
            {"check", report.check ? json_of(*report.check) : Json()},
            {"check_of_file", report.check_of_file ? json_of(*report.check_of_file) : Json()},
            {"seconds", json_of(report.seconds)},
            {"peak_memory_bytes", report.peak_memory_bytes},
            // Last, since it is long.
            {"profiles",
             {{"count", report.profiles.depths_m.size()},
              {"spacing", report.profiles.spacing},
              {"depths", report.profiles.depths_m}}}};
  if (report.names) json["names"] = Json::parse(names_as_json(*report.names));
  if (!report.furniture.empty()) json["furniture"] = Json::parse(furniture_as_json(report));
  // Paths may be in any encoding; JSON is UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_report(const RunReport& report, const std::string& path, bool overwrite) {
  OutputFile place(path, overwrite);
  std::ofstream file(place.temporary_path(), std::ios::binary | std::ios::trunc);
  const bool view_alone = std::filesystem::path(path).extension() == ".toml";
  file << (view_alone ? view_file_text(report.view.phigs) : report_text(report));
  file.close();
  if (!file)
    throw Error("can't write the report '" + path + "'",
                "make room on the disk, or choose another");
  place.commit();
}

} // namespace orograph
