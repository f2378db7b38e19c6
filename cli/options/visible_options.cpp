// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph visible`: its options, and what a command line asks of it; and the skyline's table.
#include "cli/options/check_settings.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "cli/options/options.hpp"
#include "cli/options/parse_arguments.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace orograph {
namespace {

// Of those of a picture.
constexpr std::array<std::string_view, 8> kOfView{"--eye",
                                                  "--eye-lonlat",
                                                  "--eye-height",
                                                  "--eye-summit",
                                                  "--curvature",
                                                  "--refraction",
                                                  "--curvature-coefficient",
                                                  "--exaggeration"};

void add_eye(Command& command, RenderSettings& settings) {
  command.conflicts.push_back({"--eye", "--eye-lonlat", "give one of the two"});
  command.conflicts.push_back({"--refraction", "--curvature-coefficient", "give one of the two"});
  std::vector<Option> of_view;
  add_view_options(of_view, settings);
  for (Option& option : of_view)
    if (std::ranges::find(kOfView, option.name) != kOfView.end()) {
      if (option.name == "--eye")
        option.help = "Stand at this point, without Z on the ground there";
      if (option.name == "--exaggeration") option.by_default = "1";
      if (option.name == "--curvature")
        option.help = "Take the earth's curvature into account: auto does so where the terrain's "
                      "CRS tells where on the earth it is";
      command.options.push_back(std::move(option));
    }
}

void check_eye_is_there(const ViewSpec& view) {
  if (!view.has_eye())
    throw UsageError("there is no eye to look from",
                     "give --eye X,Y[,Z] or --eye-lonlat LON,LAT[,H]");
}

void add_target_height(std::vector<Option>& options, VisibleSettings& s) {
  options.push_back(
      with_number({.group = "View",
                   .name = "--target-height",
                   .value = "M",
                   .help = "How high above the ground the points are, as a tower's top is",
                   .by_default = fmt::format("{}", s.target_height_m)},
                  {.unit = "metres", .low = 0}, [&s](double m) { s.target_height_m = m; }));
}

void add_visible_options(std::vector<Option>& options, VisibleSettings& s) {
  add_target_height(options, s);
  options.push_back({.group = kOutput,
                     .name = "--output",
                     .value = "FILE",
                     .help = "Write the points to this file",
                     .allowed = "a file whose extension names the format, csv or geojson, or - for "
                                "standard output",
                     .by_default = "- in CSV",
                     .take = stored_name(s.output)});
  options.push_back(with_choice<PointFormat>(
      {.group = kOutput,
       .name = "--of",
       .help = "Format of the points",
       .by_default = "by --output"},
      {{"csv", PointFormat::csv}, {"geojson", PointFormat::geojson}}, s.format));
  add_skyline_options(options, s.render);
  options.push_back({.group = kOutput,
                     .name = "--overwrite",
                     .help = "Replace these files where they exist",
                     .take = set_to(s.render.write.overwrite, true)});
}

} // namespace

void add_skyline_options(std::vector<Option>& options, RenderSettings& s) {
  options.push_back({.group = kOutput,
                     .name = "--horizon-table",
                     .value = "FILE.csv",
                     .help = "Write the eye's skyline all round as a table: azimuth from true "
                             "north, altitude, distance, longitude and latitude",
                     .allowed = "a file name",
                     .take = stored_name(s.skyline_table)});
  options.push_back(with_number({.group = kOutput,
                                 .name = "--horizon-step",
                                 .value = "DEG",
                                 .help = "Of --horizon-table: from a direction to the next",
                                 .by_default = fmt::format("{}", s.skyline_step_deg)},
                                {.unit = "degrees", .low = 0.001, .high = 90},
                                [&s](double deg) { s.skyline_step_deg = deg; }));
}

void check_skyline(const RenderSettings& settings, const GivenOptions& given) {
  if (settings.skyline_table.empty()) {
    if (insists_on(given, "--horizon-step"))
      throw UsageError("--horizon-step has no meaning without a table",
                       "give --horizon-table FILE.csv too");
    return;
  }
  if (!settings.map.view.has_eye())
    throw UsageError("--horizon-table needs an eye to look around from",
                     "give --eye X,Y or --eye-lonlat LON,LAT too");
  check_output_file(settings, settings.skyline_table, "--horizon-table");
}

Command visible_command(VisibleSettings& settings) {
  RenderSettings& render = settings.render;
  Command command{
      .name = "visible",
      .summary = "Tell which of many points an eye sees, and by how much others are hidden",
      .options = {},
      .conflicts = terrain_conflicts(),
      .examples = {{"orograph visible dem.tif peaks.csv --eye-lonlat 6.9,45.8 --eye-summit",
                    "Which peaks are seen from the summit there, as CSV."},
                   {"orograph visible dem.tif houses.gpkg --eye 2508,4071 --eye-height 120",
                    "From which houses a mast is seen, 120 m high."}}};
  add_terrain_options(command.options, render.inputs, render.reading);
  command.options.insert(
      command.options.begin() + 1,
      {.name = "POINTS",
       .help = "the points: a vector file that GDAL reads (GeoPackage, Shapefile, GeoJSON, GPX), "
               "FILE:LAYER where it has several layers, or CSV with columns lon and lat, or x and "
               "y in the terrain's CRS",
       .take = [&settings](const std::string& text) {
         settings.points = parse_overlay(text);
         settings.points.everywhere = true;
         return !settings.points.path.empty();
       }});
  add_eye(command, render);
  add_visible_options(command.options, settings);
  command.options.push_back(jobs_option(render.jobs));
  command.options.push_back(memory_option(render.reading.max_memory));
  command.options.push_back(quiet_option(render.quiet));
  command.options.push_back(help_option());
  return command;
}

std::optional<VisibleSettings> parse_visible(const std::vector<std::string>& arguments) {
  VisibleSettings settings;
  const auto given = parse_arguments(visible_command(settings), arguments);
  if (given.contains("--help")) return std::nullopt;
  refuse_scenes(settings.render.inputs);
  check_eye_is_there(settings.render.map.view);
  settings.points.allow_network = settings.render.reading.allow_network;
  settings.render.overlays = {settings.points}; // an input that no output may replace
  check_picture_settings(settings.render, given);
  if (!given.contains("--of") && settings.output != "-") {
    const auto format = point_format_of(settings.output);
    if (!format)
      throw UsageError(fmt::format("--output '{}' names no format of points", settings.output),
                       "end its name in .csv or .geojson, or give --of");
    settings.format = *format;
  }
  if (settings.output != "-") check_output_file(settings.render, settings.output, "--output");
  settings.render.output = settings.output;
  check_skyline(settings.render, given);
  return settings;
}

Command sights_command(VisibleSettings& settings) {
  Command command{.name = "visible",
                  .summary = "Tell which of many points an eye sees",
                  .options = {},
                  .conflicts = {},
                  .examples = {}};
  add_eye(command, settings.render);
  add_target_height(command.options, settings);
  command.options.push_back(jobs_option(settings.render.jobs));
  return command;
}

Command skyline_command(VisibleSettings& settings) {
  Command command{.name = "horizon",
                  .summary = "Tell the skyline of an eye all round",
                  .options = {},
                  .conflicts = {},
                  .examples = {}};
  add_eye(command, settings.render);
  add_skyline_options(command.options, settings.render);
  std::erase_if(command.options, [](const Option& of) { return of.name == "--horizon-table"; });
  command.options.push_back(jobs_option(settings.render.jobs));
  return command;
}

namespace {

VisibleSettings taken(Command (*command)(VisibleSettings&), const NamedValues& options) {
  VisibleSettings settings;
  const auto given = take_named(command(settings), options);
  check_eye_is_there(settings.render.map.view);
  check_picture_settings(settings.render, given);
  return settings;
}

} // namespace

VisibleSettings take_sights(const NamedValues& options) {
  return taken(sights_command, options);
}

VisibleSettings take_skyline(const NamedValues& options) {
  return taken(skyline_command, options);
}

} // namespace orograph
