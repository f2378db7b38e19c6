// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on the ground beside profiles: contours, a mesh, vectors, a graticule, a grid, hachures,
// and the walls of a block.
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "text/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace orograph {
namespace {

// A value of its own, or "auto", which leaves it to the library; the layer is drawn with either.
OptionGroup::Take adding_layer(RenderSettings& s, const char* layer, OptionGroup::Take take) {
  return [&s, layer, take = std::move(take)](const std::string& text) {
    if (text != "auto" && !take(text)) return false;
    s.added_layers.emplace_back(layer);
    return true;
  };
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

void add_hachure_options(OptionGroup& group, RenderSettings& s) {
  HachureSpec& hachures = s.map.style.hachures;
  group.value("--hachures", "Draw lines down the slope, heavier where it is steeper", "", "",
              [&s](const std::string&) {
                s.added_layers.emplace_back("hachures");
                return true;
              });
  group.value("--hachure-spacing Wmm", "How far apart hachures are on the page",
              "a length from 0.1mm to 100mm", "0.8mm", [&hachures](const std::string& text) {
                const auto plan = parse_spacing(text);
                const auto* spacing = plan ? std::get_if<PageSpacing>(&*plan) : nullptr;
                if (!spacing || spacing->mm < 0.1 || spacing->mm > 100) return false;
                hachures.spacing_mm = spacing->mm;
                return true;
              });
  group
      .value("--hachure-slope FROM:TO",
             "From which slope on there are hachures, and from which on they are as wide as half "
             "their spacing",
             "degrees from 0 to below 90, the second more than the first, as in 5:45", "5:45",
             [&hachures](const std::string& text) {
               const auto range = parse_range(text);
               if (!range || !(range->x >= 0 && range->x < range->y && range->y < 90)) return false;
               hachures.from_deg = range->x;
               hachures.heaviest_from_deg = range->y;
               return true;
             })
      .between(':');
}

void add_block_options(OptionGroup& group, RenderSettings& s) {
  BlockSpec& block = s.map.style.block;
  group
      .value("--block [BASE|auto]",
             "Draw the terrain as a block, with walls from its border and around voids down to a "
             "base; auto is 0.15 of the relief below the lowest height",
             "a height, 100m or 300ft or 100 in the unit of the file's heights, or auto", "",
             [&s, &block](const std::string& text) {
               block.base.reset();
               if (text != "auto") {
                 const auto heights = parse_heights(text);
                 if (!heights || heights->values.size() != 1) return false;
                 block.base = heights->values.front();
                 block.unit_m = heights->unit_m;
               }
               s.added_layers.emplace_back("block");
               return true;
             })
      .if_alone("auto");
  group.choice("--block-sides", "Whether a block's walls are hatched with upright lines",
               {{"lines", BlockSides::lines}, {"outline", BlockSides::outline}}, block.sides,
               "lines; outline where contours go across the walls");
}

} // namespace

void add_ground_line_options(std::vector<Option>& options, RenderSettings& s) {
  OptionGroup group(options, "Lines on the ground");
  Style& style = s.map.style;
  group.value("--contours INTERVAL|LIST|auto",
              "Draw contours, every so many metres or feet, or at the heights of a list",
              "an interval above 0, 100m or 200ft or 50 in the unit of the file's heights, or "
              "different heights with commas between, 500,1000,1500m",
              "", adding_layer(s, "contours", [&style](const std::string& text) {
                return take_contours(text, style.contours);
              }));
  group.number(
      "--contour-offset HEIGHT",
      "A height that has a contour; others are whole intervals from it; in the unit of --contours",
      {}, style.contours.offset);
  group.whole("--index-every N",
              "Every N-th contour is heavier, in the layer index-contours; 0 makes all alike", 0,
              1000, style.contours.index_every);
  group.flag(
      "--contour-ticks",
      "Ticks down the slope from closed contours around lower ground, such as pits and craters",
      style.contours.ticks);
  group.value("--mesh SPACING|COUNT|auto",
              "Draw a mesh on the ground, a line every so many metres, or so many lines across its "
              "longer side",
              "a length above 0 as in 500m, or a whole number from 1 to 10000", "",
              adding_layer(s, "mesh", [&style](const std::string& text) {
                return take_mesh(text, style.mesh);
              }));
  group.value("--mesh-lines both|x|y", "Which lines of the mesh: of one x, of one y, or both", "",
              "both", [&style](const std::string& text) {
                style.mesh.x = text != "y";
                style.mesh.y = text != "x";
                return text == "both" || text == "x" || text == "y";
              });
  group.choice("--mesh-along",
               "Whether the mesh's x and y are the map's, or to the right and away from the viewer",
               {{"map", false}, {"view", true}}, style.mesh.along_view);
  group
      .value(
          "--drape FILE[:LAYER]",
          "Lay roads, rivers, borders or points of a vector file on the ground; may be given again",
          "a file that GDAL reads as vectors, and its layer where it has several", "",
          [&s](const std::string& text) {
            if (text.empty()) return false;
            s.overlays.push_back(parse_overlay(text));
            s.added_layers.emplace_back("drape");
            return true;
          })
      .repeatable();
  group.name("--drape-where CONDITION", "Only features that meet it, as SQL has it behind WHERE",
             "as in \"class = 'river' AND width > 5\"", "", s.overlays_where);
  group.number("--drape-offset M", "How much higher than the ground they are drawn",
               {.unit = "m", .low = 0, .high = 10000}, style.overlay_above_m);
  group.value("--graticule STEP|auto", "Draw meridians and parallels, whatever the terrain's CRS",
              "degrees, minutes or seconds above 0, as in 0.5, 10' or 30''", "",
              adding_layer(s, "graticule", [&style](const std::string& text) {
                style.graticule_deg = parse_arc_deg(text);
                return style.graticule_deg && *style.graticule_deg > 0;
              }));
  group.value("--grid SPACING|auto", "Draw lines of the map's eastings and northings",
              "a length above 0, as in 1000m", "",
              adding_layer(s, "grid", [&style](const std::string& text) {
                style.grid_m = parse_metres(text);
                return style.grid_m && *style.grid_m > 0;
              }));
  add_hachure_options(group, s);
  add_block_options(group, s);
}

} // namespace orograph
