// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on the ground beside profiles: contours, a mesh, a graticule, a grid.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace orograph {
namespace {

// A value of its own, or "auto", which leaves it to the library; the layer is drawn with either.
Option adding_layer(Option option, RenderSettings& s, const char* layer,
                    const std::function<bool(const std::string&)>& take) {
  option.take = [&s, layer, take](const std::string& text) {
    if (text != "auto" && !take(text)) return false;
    s.added_layers.emplace_back(layer);
    return true;
  };
  return option;
}

bool take_contours(const std::string& text, ContourSpec& contours) {
  const auto heights = parse_heights(text);
  if (!heights) return false;
  contours.unit_m = heights->unit_m;
  contours.levels.clear();
  contours.interval.reset();
  if (heights->values.size() > 1) {
    contours.levels = heights->values;
    std::sort(contours.levels.begin(), contours.levels.end());
    return std::adjacent_find(contours.levels.begin(), contours.levels.end()) ==
           contours.levels.end();
  }
  contours.interval = heights->values.front();
  return *contours.interval > 0;
}

bool take_mesh(const std::string& text, MeshSpec& mesh) {
  mesh.spacing_m.reset();
  if (const auto count = parse_integer(text)) {
    mesh.count = *count;
    return mesh.count >= 1 && mesh.count <= 10000;
  }
  mesh.spacing_m = parse_metres(text);
  return mesh.spacing_m && *mesh.spacing_m > 0;
}

} // namespace

void add_ground_line_options(std::vector<Option>& options, RenderSettings& s) {
  constexpr auto kGroup = "Lines on the ground";
  Style& style = s.map.style;
  options.push_back(adding_layer(
      {.group = kGroup,
       .name = "--contours",
       .value = "INTERVAL|LIST|auto",
       .help = "Draw contours, every so many metres or feet, or at the heights of a list",
       .allowed = "an interval above 0, 100m or 200ft or 50 in the unit of the file's heights, or "
                  "different heights with commas between, 500,1000,1500m"},
      s, "contours",
      [&style](const std::string& text) { return take_contours(text, style.contours); }));
  options.push_back(with_number({.group = kGroup,
                                 .name = "--contour-offset",
                                 .value = "HEIGHT",
                                 .help = "A height that has a contour; others are whole intervals "
                                         "from it; in the unit of --contours",
                                 .by_default = "0"},
                                {}, [&style](double offset) { style.contours.offset = offset; }));
  options.push_back(with_integer(
      {.group = kGroup,
       .name = "--index-every",
       .value = "N",
       .help = "Every N-th contour is heavier, in the layer index-contours; 0 makes all alike",
       .by_default = fmt::format("{}", ContourSpec{}.index_every)},
      0, 1000, [&style](int every) { style.contours.index_every = every; }));
  options.push_back({.group = kGroup,
                     .name = "--contour-ticks",
                     .help = "Ticks down the slope from closed contours around lower ground, such "
                             "as pits and craters",
                     .take = set_to(style.contours.ticks, true)});
  options.push_back(adding_layer(
      {.group = kGroup,
       .name = "--mesh",
       .value = "SPACING|COUNT|auto",
       .help = "Draw a mesh on the ground, a line every so many metres, or so many lines across "
               "its longer side",
       .allowed = "a length above 0 as in 500m, or a whole number from 1 to 10000"},
      s, "mesh", [&style](const std::string& text) { return take_mesh(text, style.mesh); }));
  options.push_back({.group = kGroup,
                     .name = "--mesh-lines",
                     .value = "both|x|y",
                     .help = "Which lines of the mesh: of one x, of one y, or both",
                     .by_default = "both",
                     .take = [&style](const std::string& text) {
                       style.mesh.x = text != "y";
                       style.mesh.y = text != "x";
                       return text == "both" || text == "x" || text == "y";
                     }});
  options.push_back(with_choice<bool>(
      {.group = kGroup,
       .name = "--mesh-along",
       .help = "Whether the mesh's x and y are the map's, or to the right and away from the viewer",
       .by_default = "map"},
      {{"map", false}, {"view", true}}, style.mesh.along_view));
  options.push_back({.group = kGroup,
                     .name = "--drape",
                     .value = "FILE[:LAYER]",
                     .help = "Lay roads, rivers, borders or points of a vector file on the ground; "
                             "may be given again",
                     .allowed = "a file that GDAL reads as vectors, and its layer where it has "
                                "several",
                     .repeatable = true,
                     .take = [&s](const std::string& text) {
                       if (text.empty()) return false;
                       s.overlays.push_back(parse_overlay(text));
                       s.added_layers.emplace_back("drape");
                       return true;
                     }});
  options.push_back({.group = kGroup,
                     .name = "--drape-where",
                     .value = "CONDITION",
                     .help = "Only features that meet it, as SQL has it behind WHERE",
                     .allowed = "as in \"class = 'river' AND width > 5\"",
                     .take = stored_name(s.overlays_where)});
  options.push_back(with_number({.group = kGroup,
                                 .name = "--drape-offset",
                                 .value = "M",
                                 .help = "How much higher than the ground they are drawn",
                                 .by_default = "0"},
                                {.unit = "m", .low = 0, .high = 10000},
                                [&style](double above_m) { style.overlay_above_m = above_m; }));
  options.push_back(
      adding_layer({.group = kGroup,
                    .name = "--graticule",
                    .value = "STEP|auto",
                    .help = "Draw meridians and parallels, whatever the terrain's CRS",
                    .allowed = "degrees, minutes or seconds above 0, as in 0.5, 10' or 30''"},
                   s, "graticule", [&style](const std::string& text) {
                     style.graticule_deg = parse_arc_deg(text);
                     return style.graticule_deg && *style.graticule_deg > 0;
                   }));
  options.push_back(adding_layer({.group = kGroup,
                                  .name = "--grid",
                                  .value = "SPACING|auto",
                                  .help = "Draw lines of the map's eastings and northings",
                                  .allowed = "a length above 0, as in 1000m"},
                                 s, "grid", [&style](const std::string& text) {
                                   style.grid_m = parse_metres(text);
                                   return style.grid_m && *style.grid_m > 0;
                                 }));
}

} // namespace orograph
