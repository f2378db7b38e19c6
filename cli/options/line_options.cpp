// SPDX-License-Identifier: GPL-3.0-or-later
// Which lines are drawn of the ground, and how exactly; which solids stand on it.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "draw/colour.hpp"
#include "geometry/error.hpp"
#include "map/layer_table.hpp"
#include "text/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace orograph {
namespace {

// Of all layers but those of hidden lines and of texts, which have options of their own.
std::vector<std::string> layer_names() {
  std::vector<std::string> names;
  for (const LayerRow& row : layer_table())
    if (!row.is_hidden() && row.source != LineSource::lettering) names.emplace_back(row.name);
  return names;
}

// Of those whose hidden lines may be drawn.
std::vector<std::string> names_with_hidden() {
  std::vector<std::string> names;
  for (const LayerRow& row : layer_table())
    if (row.is_hidden()) names.emplace_back(row.hidden_of);
  return names;
}

std::vector<std::string> names_of(const std::vector<LayerSpec>& layers) {
  std::vector<std::string> names;
  for (const LayerSpec& layer : layers) names.push_back(layer.name);
  return names;
}

// Whether each is there, and only once.
bool are_among(const std::vector<std::string>& known, const std::vector<std::string>& names) {
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::count(names.begin(), names.end(), name) == 1 &&
           std::count(known.begin(), known.end(), name) == 1;
  });
}

// "LAYER=COLOUR", with commas between several; each layer once.
bool take_colours(const std::string& text, std::vector<std::pair<std::string, Colour>>& colours) {
  std::vector<std::string_view> known; // hidden ones, too
  for (const LayerRow& row : layer_table()) known.push_back(row.name);
  for (const std::string& part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) return false;
    const std::string layer = part.substr(0, equals);
    if (std::ranges::find(known, layer) == known.end()) {
      const std::string_view nearest = nearest_word(layer, known);
      throw UsageError(fmt::format("--colour: there is no layer '{}'", layer),
                       nearest.empty() ? fmt::format("there are {}", fmt::join(known, ", "))
                                       : fmt::format("did you mean {}?", nearest));
    }
    if (std::ranges::find(colours, layer, &std::pair<std::string, Colour>::first) != colours.end())
      throw UsageError(fmt::format("--colour gives the layer {} two colours", layer), "give one");
    colours.emplace_back(layer, colour_of(part.substr(equals + 1)));
  }
  return true;
}

} // namespace

void add_line_options(std::vector<Option>& options, RenderSettings& s) {
  constexpr auto kGroup = "Profiles and lines";
  options.push_back(with_integer({.group = kGroup,
                                  .name = "--profiles",
                                  .value = "N",
                                  .help = "Number of profiles",
                                  .by_default = "as many as --spacing gives"},
                                 1, 100000, [&s](int n) { s.map.style.plan = ProfileCount{n}; }));
  options.push_back({.group = kGroup,
                     .name = "--spacing",
                     .value = "LENGTH",
                     .help = "Distance between profiles: on the page for level ground, or on the "
                             "ground in depth",
                     .allowed = "a length above 0 with its unit, 0.6mm on the page or 100m on the "
                                "ground",
                     .by_default = "four pen widths on the page",
                     .take = stored(parse_spacing, s.map.style.plan)});
  options.push_back(with_choice<Spread>(
      {.group = kGroup,
       .name = "--spread",
       .help = "Profiles: as close as --spacing says wherever the ground is on the page, or planes "
               "drawn as a whole",
       .by_default = "even"},
      {{"even", Spread::even}, {"planes", Spread::planes}}, s.map.style.spread));
  options.push_back({.group = kGroup,
                     .name = "--detail",
                     .value = "MM|auto|file",
                     .help =
                         "Cells of the surface that is drawn: about so large on the page; as the "
                         "lines' spacing asks; or the file's own",
                     .allowed = "millimetres from 0.01 to 100, or auto, or file",
                     .by_default = "auto; in geojson and gpkg file",
                     .words = {"auto", "file"},
                     .take = [&s](const std::string& text) {
                       DetailSpec& detail = s.map.style.detail;
                       detail = {.of_file = text == "file"};
                       if (text == "file" || text == "auto") return true;
                       std::string_view number = text;
                       if (number.ends_with("mm")) number.remove_suffix(2);
                       detail.cell_mm = parse_number(number);
                       return detail.cell_mm && *detail.cell_mm >= 0.01 && *detail.cell_mm <= 100;
                     }});
  options.push_back(with_number(
      {.group = kGroup,
       .name = "--level-error",
       .value = "MM",
       .help = "Instead of --detail: cells as large as may be while no point of the ground is, on "
               "the page, off by more than this"},
      {.unit = "millimetres", .low = 0.001, .high = 1},
      [&s](double mm) { s.map.style.detail = {.error_mm = mm}; }));
  options.push_back({.group = kGroup,
                     .name = "--light",
                     .value = "AZ/ALT|off",
                     .help = "Where light falls from on the ground, as lines' width shows: azimuth "
                             "clockwise from north and altitude; from the picture's left; or off",
                     .allowed = "degrees, ALT from 0 to 90, or picture, or off",
                     .by_default = "picture",
                     .words = {"picture"},
                     .between = '/',
                     .take = [&s](const std::string& text) {
                       std::optional<LightSpec>& light = s.map.style.light;
                       if (text == "off") {
                         light.reset();
                         return true;
                       }
                       const auto given = parse_light(text);
                       if (!given) return false;
                       if (!light) light.emplace();
                       light->of_picture = given->of_picture;
                       light->azimuth = given->azimuth;
                       light->altitude = given->altitude;
                       return true;
                     }});
  const auto change_light = [&s](auto LightSpec::*member) {
    return [&s, member](auto value) {
      if (s.map.style.light) (*s.map.style.light).*member = value;
    };
  };
  options.push_back(
      with_number({.group = kGroup,
                   .name = "--light-contrast",
                   .value = "FACTOR",
                   .help = "How much darker and lighter slopes are than level ground; 0 "
                           "makes all alike",
                   .by_default = fmt::format("{}", LightSpec{}.contrast)},
                  {.low = 0, .high = 10}, change_light(&LightSpec::contrast)));
  options.push_back(
      with_number({.group = kGroup,
                   .name = "--light-smooth",
                   .value = "MM",
                   .help = "Light falls on the ground's mean over about this, on the page",
                   .by_default = fmt::format("{}", LightSpec{}.smooth_mm)},
                  {.unit = "mm", .low = 0, .high = 100}, change_light(&LightSpec::smooth_mm)));
  options.push_back({.group = kGroup,
                     .name = "--light-by",
                     .value = "width|density",
                     .help = "How lines show light: by their width, or, for pens of one width, by "
                             "density, how close they are",
                     .by_default = "width; in hpgl, gcode and dxf density",
                     .take = [&s](const std::string& text) {
                       if (s.map.style.light) s.map.style.light->by_density = text == "density";
                       return text == "width" || text == "density";
                     }});
  options.push_back(
      with_number({.group = kGroup,
                   .name = "--haze",
                   .value = "SHARE",
                   .help = "How much of their darkness the farthest lines lose, where "
                           "there is light",
                   .by_default = "0.3 in perspective, else 0"},
                  {.low = 0, .high = 1}, [&s](double share) { s.map.style.haze = share; }));
  options.push_back(with_choice<Occluder>(
      {.group = kGroup,
       .name = "--occluder",
       .help = "What hides: the whole surface, exactly, or only the profiles drawn",
       .by_default = "surface"},
      {{"surface", Occluder::surface}, {"profiles", Occluder::profiles}}, s.map.style.occluder));
  options.push_back(with_choice<Underside>(
      {.group = kGroup,
       .name = "--underside",
       .help = "Draw the surface as a thin sheet with both its sides: what of its underside one "
               "sees under an edge, through a void or from below",
       .by_default = "omit: the ground is solid"},
      {{"draw", Underside::draw}, {"omit", Underside::omit}}, s.map.style.underside));
  options.push_back(
      with_number({.group = kGroup,
                   .name = "--visibility-tolerance",
                   .value = "MM",
                   .help = "Lines that lie this close to the horizon, on the page, "
                           "count as tied with it and are drawn once; 0 compares "
                           "exactly",
                   .by_default = fmt::format("{}", s.map.style.visibility_tolerance_mm)},
                  {.unit = "mm", .low = 0, .high = 10},
                  [&s](double mm) { s.map.style.visibility_tolerance_mm = mm; }));
  options.push_back(with_number({.group = kGroup,
                                 .name = "--simplify",
                                 .value = "MM",
                                 .help = "Largest displacement of a line when points are left out; "
                                         "0 keeps all",
                                 .by_default = fmt::format("{}", s.map.style.simplify_mm)},
                                {.unit = "mm", .low = 0, .high = 10},
                                [&s](double mm) { s.map.style.simplify_mm = mm; }));
  options.push_back(with_number(
      {.group = kGroup,
       .name = "--silhouette-jump",
       .value = "SHARE",
       .help = "Draw a silhouette only where the ground behind is farther "
               "by more than this share of the depth; 0 draws all",
       .by_default = fmt::format("{}", s.map.style.silhouette_jump)},
      {.low = 0, .high = 10}, [&s](double share) { s.map.style.silhouette_jump = share; }));
  options.push_back(with_number({.group = kGroup,
                                 .name = "--join",
                                 .value = "MM",
                                 .help = "Draw ridges, shores and borders as one line across gaps "
                                         "up to this; 0 bridges none",
                                 .by_default = fmt::format("{}", s.map.style.join_mm)},
                                {.unit = "mm", .low = 0, .high = 10},
                                [&s](double mm) { s.map.style.join_mm = mm; }));
  options.push_back(with_number(
      {.group = kGroup,
       .name = "--shore-smooth",
       .value = "MM",
       .help = "Draw shores smoothly, nowhere farther than this from the edges of "
               "cells that they follow; not in map formats; 0 follows cells",
       .by_default = fmt::format("{}", s.map.style.shore_smooth_mm)},
      {.unit = "mm", .low = 0, .high = 10}, [&s](double mm) { s.map.style.shore_smooth_mm = mm; }));
  options.push_back(with_number(
      {.group = kGroup,
       .name = "--min-stroke",
       .value = "MM",
       .help = "Leave out visible strokes shorter than this, those that "
               "are joined as a whole; the skyline stays",
       .by_default = fmt::format("{} on paper, 0 in map formats", kCrumb_mm)},
      {.unit = "mm", .low = 0, .high = 1000}, [&s](double mm) { s.map.style.min_stroke_mm = mm; }));
  options.push_back(with_choice<FlatGround>(
      {.group = kGroup,
       .name = "--flat",
       .help = "Level ground such as sea and lakes: only its shores, or its profiles and its "
               "border too, or lines along its shores as well",
       .by_default = "shore"},
      {{"shore", FlatGround::shore},
       {"draw", FlatGround::draw},
       {"waterlines", FlatGround::waterlines}},
      s.map.style.flat));
  options.push_back(with_choice<Outline>(
      {.group = kGroup,
       .name = "--outline",
       .help = "Where terrain ends at the horizon: one skyline all along, or border by-layer",
       .by_default = "one"},
      {{"one", Outline::one}, {"by-layer", Outline::by_layer}}, s.map.style.outline));
  options.push_back({.group = kGroup,
                     .name = "--void-edges",
                     .help = "Draw the outlines of voids, gaps that terrain encloses, as well; the "
                             "layer voids",
                     .take = set_to(s.void_edges, true)});
  options.push_back({.group = kGroup,
                     .name = "--layers",
                     .value = "LIST",
                     .help = "Layers to draw, with commas between; edges are those of the "
                             "terrain's triangles",
                     .allowed = fmt::format("each once of {}", fmt::join(layer_names(), ", ")),
                     .by_default = fmt::format("{}", fmt::join(names_of(s.map.style.layers), ",")),
                     .words = layer_names(),
                     .take = [&s](const std::string& text) {
                       const std::vector<std::string> names = split(text, ',');
                       s.map.style.layers.assign(names.begin(), names.end());
                       return are_among(layer_names(), names);
                     }});
  options.push_back(with_choice<Palette>(
      {.group = kGroup,
       .name = "--palette",
       .help = "What layers are drawn in: black and greys, or the colours that maps have (brown "
               "contours, blue shores, lines of --drape red)",
       .by_default = "mono"},
      {{"mono", Palette::mono}, {"map", Palette::map}}, s.map.style.palette));
  options.push_back(
      {.group = kGroup,
       .name = "--colour",
       .value = "LAYER=COLOUR",
       .help = "Draw a layer in this colour, whatever the palette",
       .allowed = "a layer and a colour as in shores=#2a6fa8 or contours=brown, with "
                  "commas between several",
       .repeatable = true,
       .take = [&s](const std::string& text) { return take_colours(text, s.colours); }});
  options.push_back(with_choice<std::optional<bool>>(
      {.group = kGroup,
       .name = "--hidden",
       .help = "Lines that aren't seen: leave them out, or dash those of --hidden-layers",
       .by_default = "omit"},
      {{"omit", false}, {"dash", true}}, s.dashes_hidden));
  options.push_back(
      {.group = kGroup,
       .name = "--hidden-layers",
       .value = "LIST",
       .help = "Layers whose hidden lines are dashed, each in a layer of its own, such "
               "as hidden-contours; those of solids in the layer hidden",
       .allowed = fmt::format("each once of {}", fmt::join(names_with_hidden(), ", ")),
       .by_default = "solids",
       .words = names_with_hidden(),
       .take = [&s](const std::string& text) {
         s.hidden_layers = split(text, ',');
         return are_among(names_with_hidden(), s.hidden_layers);
       }});
}

void add_scene_options(std::vector<Option>& options, RenderSettings& s) {
  constexpr auto kGroup = "Solids";
  options.push_back({.group = kGroup,
                     .name = "--scene",
                     .value = "FILE",
                     .help = "Huts, towers, masts and the like on the terrain (docs/scenes.md); a "
                             "scene as INPUT is drawn alone",
                     .allowed = "a scene in TOML",
                     .extensions = {"toml"},
                     .take = stored_name(s.scene_file)});
}

} // namespace orograph
