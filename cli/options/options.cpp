// SPDX-License-Identifier: GPL-3.0-or-later
// The commands, made of groups of options.
#include "cli/options/options.hpp"

#include "cli/options/check_settings.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_kinds.hpp"
#include "cli/options/parse_arguments.hpp"
#include "geometry/error.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orograph {

std::vector<Conflict> picture_conflicts() {
  std::vector<Conflict> conflicts{
      {"--view-from", "--eye",
       "give --view-from to frame the terrain, or --eye to stand somewhere"},
      {"--view-from", "--eye-lonlat",
       "give --view-from to frame the terrain, or --eye-lonlat to stand somewhere"},
      {"--distance", "--eye", "the distance is from --eye to --look-at"},
      {"--distance", "--eye-lonlat", "the distance is from --eye-lonlat to --look-at-lonlat"},
      {"--eye", "--eye-lonlat", "give one of the two"},
      {"--look-at", "--look-at-lonlat", "give one of the two"},
      {"--look-at", "--look-azimuth", "look at a point, or in a direction"},
      {"--look-at-lonlat", "--look-azimuth", "look at a point, or in a direction"},
      {"--look-at", "--pitch", "the point tells how steeply to look"},
      {"--look-at-lonlat", "--pitch", "the point tells how steeply to look"},
      {"--portrait", "--landscape", "give one of the two"},
      {"--view-from", "--axonometric", "give one of the two"},
      {"--projection", "--axonometric", "leave --projection out"},
      {"--oblique", "--axonometric", "give one of the two"},
      {"--refraction", "--curvature-coefficient", "give one of the two"},
      {"--progress", "--no-progress", "give one of the two"},
      {"--quiet", "--progress", "give one of the two"}};
  for (const char* option :
       {"--view-from", "--projection", "--oblique", "--axonometric", "--distance", "--fov", "--eye",
        "--eye-lonlat", "--eye-height", "--look-at", "--look-at-lonlat", "--look-azimuth",
        "--pitch", "--roll"})
    conflicts.push_back({"--view", option, "the file holds the whole view"});
  for (const Conflict& conflict : terrain_conflicts()) conflicts.push_back(conflict);
  return conflicts;
}

Command render_command(RenderSettings& settings) {
  Command command{
      .name = "render",
      .summary = "Draw a perspective map of a terrain as vectors, hidden lines gone",
      .options = {},
      .conflicts = picture_conflicts(),
      .examples = {
          {"orograph render dem.tif map.svg", "A map with the defaults, on A4."},
          {"orograph render N46E007.hgt N46E008.hgt map.svg", "Neighbouring tiles as one terrain."},
          {"orograph render dem.tif map.pdf --view-from 225/15 --page a2",
           "Seen from the south-west, low, on A2."},
          {"orograph render dem.tif map.png --eye 250800,4071000,900 --fov 60",
           "Seen from a point of the terrain's own coordinates."},
          {"orograph render dem.tif map.svg --scene huts.toml", "With huts on it."}}};
  command.conflicts.push_back({"--profiles", "--spacing", "give one of the two"});
  add_terrain_options(command.options, settings.inputs, settings.reading);
  command.options.insert(
      command.options.begin() + 1,
      {.name = "OUTPUT",
       .help = fmt::format("the drawing: a file whose extension names the format ({}), or - for "
                           "standard output",
                           fmt::join(format_names(), ", ")),
       .take = stored_name(settings.output)});
  add_view_options(command.options, settings);
  add_line_options(command.options, settings);
  add_scene_options(command.options, settings);
  add_page_options(command.options, settings);
  add_output_options(command.options, settings);
  command.options.push_back(jobs_option(settings.jobs));
  add_general_options(command.options, settings.quiet, settings.progress);
  return command;
}

Command accuracy_command(AccuracySettings& settings) {
  RenderSettings& render = settings.render;
  Command command{.name = "accuracy",
                  .summary = "Measure what each setting costs in time, and in error on paper",
                  .options = {},
                  .conflicts = picture_conflicts(),
                  .examples = {{"orograph accuracy dem.tif",
                                "The table, and accuracy.csv, .json and .svg (the curve)."},
                               {"orograph accuracy dem.tif --view-from 225/10 --profiles 100,200",
                                "Seen from the south-west, low, with two numbers of profiles."}}};
  add_terrain_options(command.options, render.inputs, render.reading);
  // Overviews are among the settings that are measured.
  std::erase_if(command.options, [](const Option& o) { return o.name == "--overview"; });
  add_view_options(command.options, render);
  add_page_options(command.options, render);
  add_accuracy_options(command.options, settings);
  command.options.push_back(jobs_option(render.jobs));
  add_general_options(command.options, render.quiet, render.progress);
  return command;
}

Command fragmentation_command(FragmentationSettings& settings) {
  RenderSettings& render = settings.render;
  Command command{
      .name = "fragmentation",
      .summary = "Measure how the horizon fragments, and what collapse keeps of it",
      .options = {},
      .conflicts = terrain_conflicts(),
      .examples = {{"orograph fragmentation dem.tif",
                    "The tables, and fragmentation.csv, -series.csv, .json and .svg (the plots)."},
                   {"orograph fragmentation dem.tif --profiles 60 --elevations 25 --azimuths 180",
                    "The paper's number of profiles, in one view."}}};
  command.conflicts.push_back({"--progress", "--no-progress", "give one of the two"});
  command.conflicts.push_back({"--quiet", "--progress", "give one of the two"});
  add_terrain_options(command.options, render.inputs, render.reading);
  add_fragmentation_options(command.options, settings);
  command.options.push_back(jobs_option(render.jobs));
  add_general_options(command.options, render.quiet, render.progress);
  return command;
}

Command info_command(InfoSettings& settings) {
  Command command{
      .name = "info",
      .summary = "Tell what a terrain is: size, cells, CRS, bounds, heights",
      .options = {},
      .conflicts = terrain_conflicts(),
      .examples = {{"orograph info dem.tif", "What the file holds, as render reads it."}}};
  add_terrain_options(command.options, settings.inputs, settings.reading);
  command.options.push_back(jobs_option(settings.jobs));
  command.options.push_back(help_option());
  return command;
}

Command tin_command(TinSettings& settings) {
  Command command{.name = "tin",
                  .summary =
                      "Write a terrain as a TIN: points triangulated, a raster with few vertices",
                  .options = {},
                  .conflicts = terrain_conflicts(),
                  .examples = {{"orograph tin survey.csv survey.gpkg --breaklines edges.gpkg",
                                "Points and breaklines as triangles."},
                               {"orograph tin dem.tif dem.ply --max-error 2m",
                                "A DEM with the vertices that keep it within 2 m in height."}}};
  add_terrain_options(command.options, settings.inputs, settings.reading);
  command.options.insert(command.options.begin() + 1,
                         {.name = "OUTPUT",
                          .help = "the TIN: a file whose extension names the format (gpkg, off, "
                                  "ply, obj)",
                          .take = stored_name(settings.output)});
  add_tin_options(command.options, settings);
  return command;
}

std::optional<RenderSettings> parse_render(const std::vector<std::string>& arguments) {
  RenderSettings settings;
  const auto given = parse_arguments(render_command(settings), arguments);
  if (given.contains("--help")) return std::nullopt;
  check_settings(settings, given);
  return settings;
}

std::optional<AccuracySettings> parse_accuracy(const std::vector<std::string>& arguments) {
  AccuracySettings settings;
  const auto given = parse_arguments(accuracy_command(settings), arguments);
  if (given.contains("--help")) return std::nullopt;
  refuse_scenes(settings.render.inputs);
  check_picture_settings(settings.render, given);
  check_prefix(settings.render, settings.prefix, {".csv", ".json", ".svg"});
  return settings;
}

std::optional<FragmentationSettings>
parse_fragmentation(const std::vector<std::string>& arguments) {
  FragmentationSettings settings;
  const auto given = parse_arguments(fragmentation_command(settings), arguments);
  if (given.contains("--help")) return std::nullopt;
  refuse_scenes(settings.render.inputs);
  check_prefix(settings.render, settings.prefix, {".csv", "-series.csv", ".json", ".svg"});
  return settings;
}

std::optional<InfoSettings> parse_info(const std::vector<std::string>& arguments) {
  InfoSettings settings;
  const auto given = parse_arguments(info_command(settings), arguments);
  if (given.contains("--help")) return std::nullopt;
  refuse_scenes(settings.inputs);
  return settings;
}

std::optional<TinSettings> parse_tin(const std::vector<std::string>& arguments) {
  TinSettings settings;
  const auto given = parse_arguments(tin_command(settings), arguments);
  if (given.contains("--help")) return std::nullopt;
  refuse_scenes(settings.inputs);
  std::vector<std::string> inputs = settings.inputs;
  inputs.push_back(settings.reading.breaklines);
  inputs.push_back(settings.reading.boundary);
  for (const std::string& input : inputs)
    if (!input.empty() && replaces_input(input, settings.output))
      throw UsageError(fmt::format("OUTPUT '{}' is an input", settings.output),
                       "give OUTPUT another name");
  return settings;
}

} // namespace orograph
