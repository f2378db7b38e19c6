// SPDX-License-Identifier: GPL-3.0-or-later
// The commands and their options.
#include "cli/options.hpp"

#include "cli/check_settings.hpp"
#include "cli/option_kinds.hpp"
#include "cli/option_values.hpp"
#include "cli/parse_arguments.hpp"
#include "draw/page.hpp"
#include "draw/write_drawing.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace orograph {
namespace {

constexpr auto kTerrain = "Terrain", kView = "View", kLines = "Profiles and lines", kPage = "Page",
               kOutput = "Output", kGeneral = "General";
const std::array<std::string, 5> kLayerNames{"profiles", "shores", "border", "silhouettes",
                                             "skyline"};

Option help_option() {
  return {.group = kGeneral,
          .name = "--help",
          .letter = 'h',
          .help = "Show this and do nothing else",
          .take = [](const std::string&) { return true; }};
}

void add_terrain(std::vector<Option>& options, std::string& input, RasterOptions& raster) {
  options.push_back({.name = "INPUT",
                     .help = "the terrain: any raster of heights that GDAL opens, in a projected "
                             "CRS or none; /vsizip/ and other /vsi paths too",
                     .take = stored_name(input)});
  options.push_back(with_integer({.group = kTerrain,
                                  .name = "--band",
                                  .letter = 'b',
                                  .value = "N",
                                  .help = "Band that holds the heights",
                                  .by_default = std::to_string(raster.band)},
                                 1, std::numeric_limits<int>::max(),
                                 [&raster](int n) { raster.band = n; }));
  options.push_back({.group = kTerrain,
                     .name = "--oo",
                     .value = "NAME=VALUE",
                     .help = "Open option for GDAL's driver; may be repeated",
                     .repeatable = true,
                     .take = [&raster](const std::string& text) {
                       const auto equals = text.find('=');
                       if (equals == 0 || equals == std::string::npos) return false;
                       raster.open_options.push_back(text);
                       return true;
                     }});
  options.push_back(
      {.group = kTerrain,
       .name = "--bbox",
       .value = "XMIN,YMIN,XMAX,YMAX",
       .help = "Keep only the terrain inside this window",
       .allowed = "coordinates of the terrain's CRS, XMIN below XMAX, YMIN below YMAX",
       .by_default = "all of it",
       .take = stored(parse_box, raster.bbox)});
  options.push_back(with_integer({.group = kTerrain,
                                  .name = "--overview",
                                  .value = "LEVEL",
                                  .help = "Read a smaller overview of the file instead of the full "
                                          "heights; 0 is the finest overview",
                                  .by_default = "full heights"},
                                 0, 100, [&raster](int level) { raster.overview = level; }));
}

void add_view(std::vector<Option>& options, RenderSettings& s) {
  constexpr auto kPoint =
      "coordinates of the terrain's CRS, height in the file's unit above its datum";
  options.push_back({.group = kView,
                     .name = "--view-from",
                     .value = "AZ/EL",
                     .help = "Where the viewer stands, seen from the terrain: azimuth clockwise "
                             "from north and elevation above the horizontal",
                     .allowed = "degrees, EL from 0 to 90",
                     .by_default = fmt::format("{}/{}", s.from_azimuth.in_degrees(),
                                               s.from_elevation.in_degrees()),
                     .take = [&s](const std::string& text) {
                       const auto from = parse_view_from(text);
                       if (!from) return false;
                       s.from_azimuth = from->azimuth;
                       s.from_elevation = from->elevation;
                       return true;
                     }});
  Option projection = with_choice<Projection>(
      {.group = kView,
       .name = "--projection",
       .help = "Kind of picture",
       .by_default = "perspective"},
      {{"perspective", Projection::perspective}, {"orthographic", Projection::orthographic}},
      s.projection);
  projection.take = [take = projection.take](const std::string& text) {
    if (text == "oblique" || text == "panorama")
      throw UsageError("--projection " + text + " doesn't work yet",
                       "use perspective or orthographic");
    return take(text);
  };
  options.push_back(std::move(projection));
  options.push_back(with_number(
      {.group = kView,
       .name = "--distance",
       .value = "M",
       .help = "From the eye to the point looked at, in space; perspective only",
       .by_default = "so far that the terrain fills --fov"},
      {.unit = "metres", .low = 0, .low_excluded = true}, [&s](double m) { s.distance_m = m; }));
  options.push_back(with_number(
      {.group = kView,
       .name = "--fov",
       .value = "DEG",
       .help = "Horizontal field of view; perspective only",
       .by_default = "30"},
      {.unit = "degrees", .low = 0, .high = 180, .low_excluded = true, .high_excluded = true},
      [&s](double deg) { s.field_of_view = Angle::degrees(deg); }));
  options.push_back({.group = kView,
                     .name = "--eye",
                     .value = "X,Y,Z",
                     .help = "Stand at this point; perspective only",
                     .allowed = kPoint,
                     .take = stored(parse_point, s.eye_map)});
  options.push_back({.group = kView,
                     .name = "--look-at",
                     .value = "X,Y,Z",
                     .help = "Look at this point",
                     .allowed = kPoint,
                     .by_default = "the terrain's centre",
                     .take = stored(parse_point, s.look_at_map)});
  options.push_back(with_number({.group = kView,
                                 .name = "--roll",
                                 .value = "DEG",
                                 .help = "Turn the picture clockwise",
                                 .by_default = "0"},
                                {.unit = "degrees"},
                                [&s](double deg) { s.roll = Angle::degrees(deg); }));
  Option exaggeration = with_number(
      {.group = kView,
       .name = "--exaggeration",
       .value = "K|auto",
       .help = "Multiply all heights, the eye's and the target's too; 1 is true, auto takes 1, 1.5 "
               "or 2 by the terrain's relief and says which",
       .by_default = "auto"},
      {.low = 0, .high = 1000, .low_excluded = true}, [&s](double k) { s.exaggeration = k; });
  exaggeration.allowed = "a factor, " + exaggeration.allowed + ", or auto";
  exaggeration.take = [&s, number = exaggeration.take](const std::string& text) {
    if (text != "auto") return number(text);
    s.exaggeration.reset();
    return true;
  };
  options.push_back(std::move(exaggeration));
}

void add_lines(std::vector<Option>& options, RenderSettings& s) {
  options.push_back(with_integer({.group = kLines,
                                  .name = "--profiles",
                                  .value = "N",
                                  .help = "Number of profiles",
                                  .by_default = "as many as --spacing gives"},
                                 1, 100000, [&s](int n) { s.plan = ProfileCount{n}; }));
  options.push_back({.group = kLines,
                     .name = "--spacing",
                     .value = "LENGTH",
                     .help = "Distance between profiles: on the page for level ground, or on the "
                             "ground in depth",
                     .allowed = "a length above 0 with its unit, 0.6mm on the page or 100m on the "
                                "ground",
                     .by_default = "four pen widths on the page",
                     .take = stored(parse_spacing, s.plan)});
  options.push_back(with_choice<Occluder>(
      {.group = kLines,
       .name = "--occluder",
       .help = "What hides: the whole surface, exactly, or only the profiles drawn",
       .by_default = "surface"},
      {{"surface", Occluder::surface}, {"profiles", Occluder::profiles}}, s.occluder));
  options.push_back(with_number({.group = kLines,
                                 .name = "--visibility-tolerance",
                                 .value = "MM",
                                 .help = "Lines that lie this close to the horizon, on the page, "
                                         "count as tied with it and are drawn once; 0 compares "
                                         "exactly",
                                 .by_default = fmt::format("{}", s.visibility_tolerance_mm)},
                                {.unit = "mm", .low = 0, .high = 10},
                                [&s](double mm) { s.visibility_tolerance_mm = mm; }));
  options.push_back(with_number({.group = kLines,
                                 .name = "--simplify",
                                 .value = "MM",
                                 .help = "Largest displacement of a line when points are left out; "
                                         "0 keeps all",
                                 .by_default = fmt::format("{}", s.simplify_mm)},
                                {.unit = "mm", .low = 0, .high = 10},
                                [&s](double mm) { s.simplify_mm = mm; }));
  options.push_back(with_choice<FlatGround>(
      {.group = kLines,
       .name = "--flat",
       .help = "Level ground such as sea and lakes: only its shores, or its profiles too",
       .by_default = "shore"},
      {{"shore", FlatGround::shore}, {"draw", FlatGround::draw}}, s.flat));
  options.push_back({.group = kLines,
                     .name = "--layers",
                     .value = "LIST",
                     .help = "Layers to draw, with commas between",
                     .allowed = fmt::format("each once of {}", fmt::join(kLayerNames, ",")),
                     .by_default = "all of them",
                     .take = [&s](const std::string& text) {
                       s.layers = split(text, ',');
                       return std::all_of(s.layers.begin(), s.layers.end(), [&](const auto& layer) {
                         return std::count(s.layers.begin(), s.layers.end(), layer) == 1 &&
                                std::count(kLayerNames.begin(), kLayerNames.end(), layer) == 1;
                       });
                     }});
}

void add_page(std::vector<Option>& options, RenderSettings& s) {
  options.push_back({.group = kPage,
                     .name = "--page",
                     .value = "NAME|WxH",
                     .help = "Paper; a named one is turned to the picture's shape",
                     .allowed = fmt::format("one of {}, or width x height in mm such as 400x250, "
                                            "each 1 to 10000",
                                            fmt::join(paper_names(), ", ")),
                     .by_default = "a4",
                     .take = [&page = s.page](const std::string& text) {
                       const auto named = paper_size_mm(text);
                       const auto size = named ? named : parse_width_x_height(text);
                       if (!size) return false;
                       page.width_mm = size->x;
                       page.height_mm = size->y;
                       if (!named && page.orientation == Orientation::by_picture)
                         page.orientation = Orientation::as_given;
                       return true;
                     }});
  options.push_back({.group = kPage,
                     .name = "--portrait",
                     .help = "Page upright",
                     .take = set_to(s.page.orientation, Orientation::portrait)});
  options.push_back({.group = kPage,
                     .name = "--landscape",
                     .help = "Page on its side",
                     .take = set_to(s.page.orientation, Orientation::landscape)});
  options.push_back(with_number({.group = kPage,
                                 .name = "--margin",
                                 .value = "MM",
                                 .help = "Empty paper on each side",
                                 .by_default = fmt::format("{}", s.page.margin_mm)},
                                {.unit = "mm", .low = 0},
                                [&s](double mm) { s.page.margin_mm = mm; }));
  options.push_back(with_number({.group = kPage,
                                 .name = "--pen-width",
                                 .value = "MM",
                                 .help = "Width of the pen that draws the profiles",
                                 .by_default = fmt::format("{}", s.pen_width_mm)},
                                {.unit = "mm", .low = 0.01, .high = 10},
                                [&s](double mm) { s.pen_width_mm = mm; }));
  options.push_back({.group = kPage,
                     .name = "--title",
                     .value = "TEXT",
                     .help = "Title in the file's metadata",
                     .by_default = "INPUT's file name",
                     .take = [&s](const std::string& text) {
                       s.title = text;
                       return true;
                     }});
}

void add_output(std::vector<Option>& options, RenderSettings& s) {
  const std::string formats = fmt::format("{}", fmt::join(format_names(), ", "));
  options.push_back({.group = kOutput,
                     .name = "--of",
                     .value = "FORMAT",
                     .help = "Format of OUTPUT",
                     .allowed = "one of " + formats,
                     .by_default = "by OUTPUT's extension",
                     .take = [&s](const std::string& text) {
                       s.write.format = format_of_name(text);
                       return true;
                     }});
  options.push_back(with_number({.group = kOutput,
                                 .name = "--dpi",
                                 .value = "N",
                                 .help = "Resolution of PNG",
                                 .by_default = fmt::format("{}", s.write.dpi)},
                                {.unit = "dots per inch", .low = 10, .high = 4800},
                                [&s](double dpi) { s.write.dpi = dpi; }));
  options.push_back({.group = kOutput,
                     .name = "--overwrite",
                     .help = "Replace OUTPUT and the report where they exist",
                     .take = set_to(s.write.overwrite, true)});
  options.push_back({.group = kOutput,
                     .name = "--report",
                     .value = "FILE.json",
                     .help = "Write what was drawn, how exactly and in which time",
                     .allowed = "a file name",
                     .take = stored_name(s.report)});
  options.push_back(with_integer({.group = kOutput,
                                  .name = "--check",
                                  .value = "N",
                                  .help = "Ask N random points of the drawing of a ray walk over "
                                          "the terrain, and tell how many are drawn wrongly",
                                  .by_default = "0"},
                                 0, 100000000,
                                 [&s](int n) { s.check = static_cast<unsigned>(n); }));
  options.push_back({.group = kGeneral,
                     .name = "--quiet",
                     .letter = 'q',
                     .help = "Only errors on stderr",
                     .take = set_to(s.quiet, true)});
  options.push_back({.group = kGeneral,
                     .name = "--progress",
                     .help = "Show the progress on stderr, the default on a terminal",
                     .take = set_to(s.progress, true)});
  options.push_back({.group = kGeneral,
                     .name = "--no-progress",
                     .help = "Don't show it",
                     .take = set_to(s.progress, false)});
}

} // namespace

Command render_command(RenderSettings& settings) {
  Command command{
      .name = "render",
      .summary = "Draw a perspective map of a terrain as vectors, hidden lines gone",
      .options = {},
      .conflicts = {{"--view-from", "--eye",
                     "give --view-from to frame the terrain, or --eye to stand somewhere"},
                    {"--distance", "--eye", "the distance is from --eye to --look-at"},
                    {"--profiles", "--spacing", "give one of the two"},
                    {"--portrait", "--landscape", "give one of the two"},
                    {"--progress", "--no-progress", "give one of the two"},
                    {"--quiet", "--progress", "give one of the two"}},
      .examples = {{"orograph render dem.tif map.svg", "A map with the defaults, on A4."},
                   {"orograph render dem.tif map.pdf --view-from 225/15 --page a2",
                    "Seen from the south-west, low, on A2."},
                   {"orograph render dem.tif map.png --eye 250800,4071000,900 --fov 60",
                    "Seen from a point of the terrain's own coordinates."}}};
  add_terrain(command.options, settings.input, settings.raster);
  command.options.insert(
      command.options.begin() + 1,
      {.name = "OUTPUT",
       .help = fmt::format("the drawing: a file whose extension names the format ({}), or - for "
                           "standard output",
                           fmt::join(format_names(), ", ")),
       .take = stored_name(settings.output)});
  add_view(command.options, settings);
  add_lines(command.options, settings);
  add_page(command.options, settings);
  add_output(command.options, settings);
  command.options.push_back(help_option());
  return command;
}

Command info_command(InfoSettings& settings) {
  Command command{
      .name = "info",
      .summary = "Tell what a terrain is: size, cells, CRS, bounds, heights",
      .options = {},
      .conflicts = {},
      .examples = {{"orograph info dem.tif", "What the file holds, as render reads it."}}};
  add_terrain(command.options, settings.input, settings.raster);
  command.options.push_back(help_option());
  return command;
}

std::optional<RenderSettings> parse_render(const std::vector<std::string>& arguments) {
  RenderSettings settings;
  const auto given = parse_arguments(render_command(settings), arguments);
  if (given.contains("--help")) return std::nullopt;
  check_settings(settings, given);
  return settings;
}

std::optional<InfoSettings> parse_info(const std::vector<std::string>& arguments) {
  InfoSettings settings;
  const auto given = parse_arguments(info_command(settings), arguments);
  if (given.contains("--help")) return std::nullopt;
  return settings;
}

} // namespace orograph
