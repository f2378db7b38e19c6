// SPDX-License-Identifier: GPL-3.0-or-later
// What a command reads of a terrain; and the two that tell of it or write it, `orograph info` and
// `orograph tin`.
#include "cli/options/check_settings.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "cli/options/options.hpp"
#include "cli/options/parse_arguments.hpp"
#include "dem/read/length_units.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <limits>
#include <map>

namespace orograph {
namespace {

void add_tin_options(std::vector<Option>& options, TinSettings& settings) {
  options.push_back({.group = kOutput,
                     .name = "--max-error",
                     .value = "LENGTH",
                     .help = "Of a raster: keep as few of its vertices as leave the TIN nowhere "
                             "farther from it in height",
                     .allowed = "a length from 0 on with its unit, such as 2m",
                     .take = stored(parse_metres, settings.max_error_m)});
  std::optional<TinFormat>& format = settings.format;
  const std::map<std::string, TinFormat> formats{{"gpkg", TinFormat::gpkg},
                                                 {"off", TinFormat::off},
                                                 {"ply", TinFormat::ply},
                                                 {"obj", TinFormat::obj}};
  options.push_back({.group = kOutput,
                     .name = "--of",
                     .value = "gpkg|off|ply|obj",
                     .help = "Format of OUTPUT",
                     .by_default = "by its extension",
                     .take = [formats, &format](const std::string& text) {
                       const auto found = formats.find(text);
                       if (found == formats.end()) return false;
                       format = found->second;
                       return true;
                     }});
  options.push_back({.group = kOutput,
                     .name = "--overwrite",
                     .help = "Replace an existing file",
                     .take = set_to(settings.overwrite, true)});
  options.push_back(jobs_option(settings.jobs));
  options.push_back(memory_option(settings.reading.max_memory));
  options.push_back(quiet_option(settings.quiet));
  options.push_back(help_option());
}

} // namespace

std::vector<Conflict> terrain_conflicts() {
  return {{"--bbox", "--bbox-lonlat", "give one of the two"}};
}

void add_terrain_options(std::vector<Option>& options, std::vector<std::string>& inputs,
                         ReadOptions& reading) {
  constexpr auto kGroup = "Terrain";
  options.push_back({.name = "INPUT",
                     .help = "the terrain: any raster of heights that GDAL opens (/vsizip/ and "
                             "other /vsi paths too), in any CRS or none; triangles in OFF, "
                             "PLY, OBJ, STL, LandXML or a vector file; points in text with named "
                             "columns or a vector file, in a projected CRS or none. Several "
                             "rasters whose cells are on one lattice are joined",
                     .repeatable = true,
                     .take = [&inputs](const std::string& text) {
                       inputs.push_back(text);
                       return !text.empty();
                     }});
  options.push_back(with_integer({.group = kGroup,
                                  .name = "--band",
                                  .letter = 'b',
                                  .value = "N",
                                  .help = "Band that holds the heights",
                                  .by_default = std::to_string(reading.band)},
                                 1, std::numeric_limits<int>::max(),
                                 [&reading](int n) { reading.band = n; }));
  options.push_back({.group = kGroup,
                     .name = "--oo",
                     .value = "NAME=VALUE",
                     .help = "Open option for GDAL's driver; may be repeated",
                     .repeatable = true,
                     .take = [&reading](const std::string& text) {
                       const auto equals = text.find('=');
                       if (equals == 0 || equals == std::string::npos) return false;
                       reading.open_options.push_back(text);
                       return true;
                     }});
  options.push_back(
      {.group = kGroup,
       .name = "--bbox",
       .value = "XMIN,YMIN,XMAX,YMAX",
       .help = "Keep only the terrain inside this window",
       .allowed = "coordinates of the terrain's CRS, XMIN below XMAX, YMIN below YMAX",
       .by_default = "all of it",
       .take = stored(parse_box, reading.bbox)});
  options.push_back({.group = kGroup,
                     .name = "--bbox-lonlat",
                     .value = "W,S,E,N",
                     .help = "The same by longitude and latitude (WGS 84), in any CRS; W above E "
                             "goes across 180 degrees",
                     .allowed = "degrees, S below N",
                     .take = stored(parse_lonlat_box, reading.bbox_lonlat)});
  options.push_back(with_integer({.group = kGroup,
                                  .name = "--overview",
                                  .value = "LEVEL",
                                  .help = "Read a smaller overview of the file instead of the full "
                                          "heights; 0 is the finest overview",
                                  .by_default = "full heights"},
                                 0, 100, [&reading](int level) { reading.overview = level; }));
  options.push_back(
      with_number({.group = kGroup,
                   .name = "--fill-voids",
                   .value = "CELLS",
                   .help = "Fill missing heights of a raster from those around them, up to so far "
                           "from a height (GDAL's fill)",
                   .by_default = "gaps stay, and hide nothing"},
                  {.unit = "cells", .low = 0, .high = 1e6, .low_excluded = true},
                  [&reading](double cells) { reading.fill_voids = cells; }));
  options.push_back(
      {.group = kGroup,
       .name = "--height-unit",
       .value = "UNIT",
       .help = "Unit of a raster's heights, where the file doesn't say it or is wrong",
       .allowed = "m, ft, us-ft, km, dm, cm or mm",
       .by_default = "the file's",
       .take = [&reading](const std::string& text) {
         reading.height_unit = text;
         return length_unit(text).has_value();
       }});
  options.push_back({.group = kGroup,
                     .name = "--allow-network",
                     .help =
                         "Let files ask servers for what they name; an INPUT that is a URL or a "
                         "/vsicurl/ path always may",
                     .take = set_to(reading.allow_network, true)});
  constexpr auto kSurvey = "Triangles and points";
  options.push_back({.group = kSurvey,
                     .name = "--input-layer",
                     .value = "NAME",
                     .help = "Layer of a vector file, or surface of a LandXML file",
                     .by_default = "the only one",
                     .take = stored_name(reading.layer)});
  options.push_back({.group = kSurvey,
                     .name = "--repair",
                     .help = "Reduce triangles that lie above each other to their upper surface",
                     .take = set_to(reading.repair, true)});
  options.push_back({.group = kSurvey,
                     .name = "--columns",
                     .value = "X,Y,Z",
                     .help = "Columns of a text file that hold easting, northing and height",
                     .allowed = "three names with commas between",
                     .by_default = "x,y,z",
                     .take = [&reading](const std::string& text) {
                       const std::vector<std::string> names = split(text, ',');
                       if (names.size() != 3 || names[0].empty() || names[1].empty() ||
                           names[2].empty())
                         return false;
                       reading.columns = {names[0], names[1], names[2]};
                       return true;
                     }});
  options.push_back({.group = kSurvey,
                     .name = "--height-field",
                     .value = "NAME",
                     .help = "Field that holds the heights of a vector file's points without Z",
                     .take = stored_name(reading.height_field)});
  options.push_back({.group = kSurvey,
                     .name = "--breaklines",
                     .value = "FILE",
                     .help = "Lines with Z that become edges of the triangulated points",
                     .take = stored_name(reading.breaklines)});
  options.push_back({.group = kSurvey,
                     .name = "--boundary",
                     .value = "FILE",
                     .help = "Polygons: points are triangulated inside them only; holes are left",
                     .take = stored_name(reading.boundary)});
  options.push_back(with_number({.group = kSurvey,
                                 .name = "--max-edge",
                                 .value = "M",
                                 .help = "Take triangles with a longer edge away, from the border "
                                         "of the triangulated points inwards",
                                 .by_default = "none"},
                                {.unit = "metres", .low = 0, .low_excluded = true},
                                [&reading](double m) { reading.max_edge_m = m; }));
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
  command.options.push_back(memory_option(settings.reading.max_memory));
  command.options.push_back(help_option());
  return command;
}

InfoSettings take_reading(const NamedValues& options) {
  InfoSettings settings;
  take_named(info_command(settings), options);
  refuse_scenes(settings.inputs);
  return settings;
}

std::optional<InfoSettings> parse_info(const std::vector<std::string>& arguments) {
  InfoSettings settings;
  const auto given = parse_arguments(info_command(settings), arguments);
  if (asks_for_help(given)) return std::nullopt;
  refuse_scenes(settings.inputs);
  return settings;
}

Command index_command(IndexSettings& settings) {
  Command command{
      .name = "index",
      .summary = "Read a large raster once and keep larger cells of it beside it, for render",
      .options = {},
      .conflicts = terrain_conflicts(),
      .examples = {{"orograph index dem.tif", "Writes dem.tif.levels, which render finds."}}};
  add_terrain_options(command.options, settings.inputs, settings.reading);
  command.options.push_back(jobs_option(settings.jobs));
  command.options.push_back(memory_option(settings.reading.max_memory));
  add_message_options(command.options, settings.quiet, settings.progress);
  return command;
}

std::optional<IndexSettings> parse_index(const std::vector<std::string>& arguments) {
  IndexSettings settings;
  const auto given = parse_arguments(index_command(settings), arguments);
  if (asks_for_help(given)) return std::nullopt;
  refuse_scenes(settings.inputs);
  return settings;
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

std::optional<TinSettings> parse_tin(const std::vector<std::string>& arguments) {
  TinSettings settings;
  const auto given = parse_arguments(tin_command(settings), arguments);
  if (asks_for_help(given)) return std::nullopt;
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
