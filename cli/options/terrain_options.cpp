// SPDX-License-Identifier: GPL-3.0-or-later
// What a command reads of a terrain; and the two that tell of it or write it, `orograph info` and
// `orograph tin`.
#include "cli/options/check_settings.hpp"
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "cli/options/options.hpp"
#include "cli/options/parse_arguments.hpp"
#include "dem/read/length_units.hpp"
#include "geometry/error.hpp"
#include "text/quantities.hpp"
#include "text/words.hpp"
#include "write/same_file.hpp"

#include <fmt/format.h>

#include <limits>

namespace orograph {
namespace {

void add_tin_options(std::vector<Option>& options, TinSettings& settings) {
  OptionGroup group(options, kOutput);
  group.parsed(
      "--max-error LENGTH",
      "Of a raster: keep as few of its vertices as leave the TIN nowhere farther from it in height",
      "a length from 0 on with its unit, such as 2m", "", parse_metres, settings.max_error_m);
  group.choice("--of", "Format of OUTPUT",
               {{"gpkg", TinFormat::gpkg},
                {"off", TinFormat::off},
                {"ply", TinFormat::ply},
                {"obj", TinFormat::obj}},
               settings.format, "by its extension");
  group.flag("--overwrite", "Replace an existing file", settings.overwrite);
  add_jobs(options, settings.jobs);
  add_memory(options, settings.reading.max_memory);
  add_quiet(options, settings.quiet);
  add_help(options);
}

} // namespace

std::vector<Conflict> terrain_conflicts() {
  return {{"--bbox", "--bbox-lonlat", "give one of the two"}};
}

void add_input(std::vector<Option>& options, std::vector<std::string>& inputs) {
  OptionGroup(options)
      .value(
          "INPUT",
          "the terrain: any raster of heights that GDAL opens (/vsizip/ and other /vsi paths too), "
          "in any CRS or none; triangles in OFF, PLY, OBJ, STL, LandXML or a vector file; points "
          "in text with named columns or a vector file, in a projected CRS or none. Several "
          "rasters whose cells are on one lattice are joined",
          "", "",
          [&inputs](const std::string& text) {
            inputs.push_back(text);
            return !text.empty();
          })
      .repeatable();
}

void add_terrain_options(std::vector<Option>& options, ReadOptions& reading) {
  OptionGroup group(options, "Terrain");
  group.whole("-b, --band N", "Band that holds the heights", 1, std::numeric_limits<int>::max(),
              reading.band);
  group
      .value("--oo NAME=VALUE", "Open option for GDAL's driver; may be repeated", "", "",
             [&reading](const std::string& text) {
               const auto equals = text.find('=');
               if (equals == 0 || equals == std::string::npos) return false;
               reading.open_options.push_back(text);
               return true;
             })
      .repeatable();
  group.parsed("--bbox XMIN,YMIN,XMAX,YMAX", "Keep only the terrain inside this window",
               "coordinates of the terrain's CRS, XMIN below XMAX, YMIN below YMAX", "all of it",
               parse_box, reading.bbox);
  group.parsed(
      "--bbox-lonlat W,S,E,N",
      "The same by longitude and latitude (WGS 84), in any CRS; W above E goes across 180 degrees",
      "degrees, S below N", "", parse_lonlat_box, reading.bbox_lonlat);
  group.whole(
      "--overview LEVEL",
      "Read a smaller overview of the file instead of the full heights; 0 is the finest overview",
      0, 100, reading.overview, "full heights");
  group.number("--fill-voids CELLS",
               "Fill missing heights of a raster from those around them, up to so far from a "
               "height (GDAL's fill)",
               {.unit = "cells", .low = 0, .high = 1e6, .low_excluded = true}, reading.fill_voids,
               "gaps stay, and hide nothing");
  group.value("--height-unit UNIT",
              "Unit of a raster's heights, where the file doesn't say it or is wrong",
              "m, ft, us-ft, km, dm, cm or mm", "the file's", [&reading](const std::string& text) {
                reading.height_unit = text;
                return length_unit(text).has_value();
              });
  group.flag("--allow-network",
             "Let files ask servers for what they name; an INPUT that is a URL or a /vsicurl/ path "
             "always may",
             reading.allow_network);
  OptionGroup survey(options, "Triangles and points");
  survey.name("--input-layer NAME", "Layer of a vector file, or surface of a LandXML file", "",
              "the only one", reading.layer);
  survey.flag("--repair", "Reduce triangles that lie above each other to their upper surface",
              reading.repair);
  survey.value("--columns X,Y,Z", "Columns of a text file that hold easting, northing and height",
               "three names with commas between", "x,y,z", [&reading](const std::string& text) {
                 const std::vector<std::string> names = split(text, ',');
                 if (names.size() != 3 || names[0].empty() || names[1].empty() || names[2].empty())
                   return false;
                 reading.columns = {names[0], names[1], names[2]};
                 return true;
               });
  survey.name("--height-field NAME",
              "Field that holds the heights of a vector file's points without Z", "", "",
              reading.height_field);
  survey.name("--breaklines FILE", "Lines with Z that become edges of the triangulated points", "",
              "", reading.breaklines);
  survey.name("--boundary FILE",
              "Polygons: points are triangulated inside them only; holes are left", "", "",
              reading.boundary);
  survey.number(
      "--max-edge M",
      "Take triangles with a longer edge away, from the border of the triangulated points inwards",
      {.unit = "metres", .low = 0, .low_excluded = true}, reading.max_edge_m, "none");
}

Command info_command(InfoSettings& settings) {
  Command command{
      .name = "info",
      .summary = "Tell what a terrain is: size, cells, CRS, bounds, heights",
      .options = {},
      .conflicts = terrain_conflicts(),
      .examples = {{"orograph info dem.tif", "What the file holds, as render reads it."}}};
  add_input(command.options, settings.inputs);
  add_terrain_options(command.options, settings.reading);
  add_jobs(command.options, settings.jobs);
  add_memory(command.options, settings.reading.max_memory);
  add_help(command.options);
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
  add_input(command.options, settings.inputs);
  add_terrain_options(command.options, settings.reading);
  add_jobs(command.options, settings.jobs);
  add_memory(command.options, settings.reading.max_memory);
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
  add_input(command.options, settings.inputs);
  OptionGroup(command.options)
      .name("OUTPUT", "the TIN: a file whose extension names the format (gpkg, off, ply, obj)", "",
            "", settings.output);
  add_terrain_options(command.options, settings.reading);
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
