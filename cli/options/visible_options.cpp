// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph visible`: its options, and what a command line asks of it; and the skyline's table.
#include "cli/options/check_settings.hpp"
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "cli/options/options.hpp"
#include "cli/options/parse_arguments.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace orograph {
namespace {

// Of those of a picture.
constexpr std::string_view kOfView =
    "--eye --eye-lonlat --eye-height --eye-summit --curvature --refraction "
    "--curvature-coefficient --exaggeration";

void add_eye(Command& command, RenderSettings& settings) {
  command.conflicts.push_back({"--eye", "--eye-lonlat", "give one of the two"});
  command.conflicts.push_back({"--refraction", "--curvature-coefficient", "give one of the two"});
  std::vector<Option> of_view;
  add_view_options(of_view, settings);
  for (Option& option : of_view)
    if (is_among(kOfView, option.name)) {
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
  OptionGroup(options, "View")
      .number("--target-height M", "How high above the ground the points are, as a tower's top is",
              {.unit = "metres", .low = 0}, s.target_height_m);
}

void add_visible_options(std::vector<Option>& options, VisibleSettings& s) {
  add_target_height(options, s);
  OptionGroup group(options, kOutput);
  group.name("--output FILE", "Write the points to this file",
             "a file whose extension names the format, csv or geojson, or - for standard output",
             "- in CSV", s.output);
  group.choice("--of", "Format of the points",
               {{"csv", PointFormat::csv}, {"geojson", PointFormat::geojson}}, s.format,
               "by --output");
  add_skyline_options(options, s.render);
  group.flag("--overwrite", "Replace these files where they exist", s.render.write.overwrite);
}

} // namespace

void add_skyline_options(std::vector<Option>& options, RenderSettings& s) {
  OptionGroup group(options, kOutput);
  group.name("--horizon-table FILE.csv",
             "Write the eye's skyline all round as a table: azimuth from true north, altitude, "
             "distance, longitude and latitude",
             "a file name", "", s.skyline_table);
  group.number("--horizon-step DEG", "Of --horizon-table: from a direction to the next",
               {.unit = "degrees", .low = 0.001, .high = 90}, s.skyline_step_deg);
}

void check_skyline(const RenderSettings& settings, const GivenOptions& given) {
  if (settings.skyline_table.empty()) {
    refuse(given, "--horizon-step", "without a table", "give --horizon-table FILE.csv too");
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
  add_input(command.options, render.inputs);
  OptionGroup(command.options)
      .value("POINTS",
             "the points: a vector file that GDAL reads (GeoPackage, Shapefile, GeoJSON, GPX), "
             "FILE:LAYER where it has several layers, or CSV with columns lon and lat, or x and y "
             "in the terrain's CRS",
             "", "", [&settings](const std::string& text) {
               settings.points = parse_overlay(text);
               settings.points.everywhere = true;
               return !settings.points.path.empty();
             });
  add_terrain_options(command.options, render.reading);
  add_eye(command, render);
  add_visible_options(command.options, settings);
  add_jobs(command.options, render.jobs);
  add_memory(command.options, render.reading.max_memory);
  add_quiet(command.options, render.quiet);
  add_help(command.options);
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
  add_jobs(command.options, settings.render.jobs);
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
  add_jobs(command.options, settings.render.jobs);
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
