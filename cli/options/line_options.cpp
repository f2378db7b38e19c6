// SPDX-License-Identifier: GPL-3.0-or-later
// Which lines are drawn of the ground, and how exactly; which solids stand on it.
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "draw/colour.hpp"
#include "geometry/error.hpp"
#include "map/layer_table.hpp"
#include "text/quantities.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

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
                       nearest.empty() ? fmt::format("there are {}", joined(known, ", "))
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
  Style& style = s.map.style;
  OptionGroup group(options, "Profiles and lines");
  const auto change_light = [&style](double LightSpec::*member) {
    return [&style, member](double value) {
      if (style.light) (*style.light).*member = value;
    };
  };
  const auto take_count = [&style](int n) { style.plan = ProfileCount{n}; };
  group.whole("--profiles N", "Number of profiles", 1, 100000, take_count,
              "as many as --spacing gives");
  group.parsed("--spacing LENGTH",
               "Distance between profiles: on the page for level ground, or on the ground in depth",
               "a length above 0 with its unit, 0.6mm on the page or 100m on the ground",
               "four pen widths on the page", parse_spacing, style.plan);
  group.choice("--spread",
               "Profiles: as close as --spacing says wherever the ground is on the page, or planes "
               "drawn as a whole",
               {{"even", Spread::even}, {"planes", Spread::planes}}, style.spread);
  group
      .value("--detail MM|auto|file",
             "Cells of the surface that is drawn: about so large on the page; as the lines' "
             "spacing asks; or the file's own",
             "millimetres from 0.01 to 100, or auto, or file", "auto; in geojson and gpkg file",
             [&style](const std::string& text) {
               DetailSpec& detail = style.detail;
               detail = {.of_file = text == "file"};
               if (text == "file" || text == "auto") return true;
               std::string_view number = text;
               if (number.ends_with("mm")) number.remove_suffix(2);
               detail.cell_mm = parse_number(number);
               return detail.cell_mm && *detail.cell_mm >= 0.01 && *detail.cell_mm <= 100;
             })
      .words({"auto", "file"});
  group.number("--level-error MM",
               "Instead of --detail: cells as large as may be while no point of the ground is, on "
               "the page, off by more than this",
               {.unit = "millimetres", .low = 0.001, .high = 1},
               [&style](double mm) { style.detail = {.error_mm = mm}; });
  group
      .value("--light AZ/ALT|off",
             "Where light falls from on the ground, as lines' width shows: azimuth clockwise from "
             "north and altitude; from the picture's left; or off",
             "degrees, ALT from 0 to 90, or picture, or off", "picture",
             [&style](const std::string& text) {
               std::optional<LightSpec>& light = style.light;
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
             })
      .words({"picture"})
      .between('/');
  group.number("--light-contrast FACTOR",
               "How much darker and lighter slopes are than level ground; 0 makes all alike",
               {.low = 0, .high = 10}, change_light(&LightSpec::contrast),
               fmt::format("{}", LightSpec{}.contrast));
  group.number("--light-smooth MM", "Light falls on the ground's mean over about this, on the page",
               {.unit = "mm", .low = 0, .high = 100}, change_light(&LightSpec::smooth_mm),
               fmt::format("{}", LightSpec{}.smooth_mm));
  group.value("--light-by width|density",
              "How lines show light: by their width, or, for pens of one width, by density, how "
              "close they are",
              "", "width; in hpgl, gcode and dxf density", [&style](const std::string& text) {
                if (style.light) style.light->by_density = text == "density";
                return text == "width" || text == "density";
              });
  group.number("--haze SHARE",
               "How much of their darkness the farthest lines lose, where there is light",
               {.low = 0, .high = 1}, style.haze, "0.3 in perspective, else 0");
  group.choice("--occluder", "What hides: the whole surface, exactly, or only the profiles drawn",
               {{"surface", Occluder::surface}, {"profiles", Occluder::profiles}}, style.occluder);
  group.choice("--underside",
               "Draw the surface as a thin sheet with both its sides: what of its underside one "
               "sees under an edge, through a void or from below",
               {{"draw", Underside::draw}, {"omit", Underside::omit}}, style.underside,
               "omit: the ground is solid");
  group.number("--visibility-tolerance MM",
               "Lines that lie this close to the horizon, on the page, count as tied with it and "
               "are drawn once; 0 compares exactly",
               {.unit = "mm", .low = 0, .high = 10}, style.visibility_tolerance_mm);
  group.number("--simplify MM",
               "Largest displacement of a line when points are left out; 0 keeps all",
               {.unit = "mm", .low = 0, .high = 10}, style.simplify_mm);
  group.number("--silhouette-jump SHARE",
               "Draw a silhouette only where the ground behind is farther by more than this share "
               "of the depth; 0 draws all",
               {.low = 0, .high = 10}, style.silhouette_jump);
  group.number("--join MM",
               "Draw ridges, shores and borders as one line across gaps up to this; 0 bridges none",
               {.unit = "mm", .low = 0, .high = 10}, style.join_mm);
  group.number("--shore-smooth MM",
               "Draw shores smoothly, nowhere farther than this from the edges of cells that they "
               "follow; not in map formats; 0 follows cells",
               {.unit = "mm", .low = 0, .high = 10}, style.shore_smooth_mm);
  group.number("--min-stroke MM",
               "Leave out visible strokes shorter than this, those that are joined as a whole; the "
               "skyline stays",
               {.unit = "mm", .low = 0, .high = 1000}, style.min_stroke_mm,
               fmt::format("{} on paper, 0 in map formats", kCrumb_mm));
  group.choice("--flat",
               "Level ground such as sea and lakes: only its shores, or its profiles and its "
               "border too, or lines along its shores as well",
               {{"shore", FlatGround::shore},
                {"draw", FlatGround::draw},
                {"waterlines", FlatGround::waterlines}},
               style.flat);
  group.choice("--outline",
               "Where terrain ends at the horizon: one skyline all along, or border by-layer",
               {{"one", Outline::one}, {"by-layer", Outline::by_layer}}, style.outline);
  group.flag("--void-edges",
             "Draw the outlines of voids, gaps that terrain encloses, as well; the layer voids",
             s.void_edges);
  group
      .value("--layers LIST",
             "Layers to draw, with commas between; edges are those of the terrain's triangles",
             fmt::format("each once of {}", joined(layer_names(), ", ")),
             joined(names_of(style.layers), ","),
             [&style](const std::string& text) {
               const std::vector<std::string> names = split(text, ',');
               style.layers.assign(names.begin(), names.end());
               return are_among(layer_names(), names);
             })
      .words(layer_names());
  group.choice("--palette",
               "What layers are drawn in: black and greys, or the colours that maps have (brown "
               "contours, blue shores, lines of --drape red)",
               {{"mono", Palette::mono}, {"map", Palette::map}}, style.palette);
  group
      .value("--colour LAYER=COLOUR", "Draw a layer in this colour, whatever the palette",
             "a layer and a colour as in shores=#2a6fa8 or contours=brown, with commas between "
             "several",
             "", [&s](const std::string& text) { return take_colours(text, s.colours); })
      .repeatable();
  group.choice("--hidden",
               "Lines that aren't seen: leave them out, or dash those of --hidden-layers",
               {{"omit", false}, {"dash", true}}, s.dashes_hidden, "omit");
  group
      .value("--hidden-layers LIST",
             "Layers whose hidden lines are dashed, each in a layer of its own, such as "
             "hidden-contours; those of solids in the layer hidden",
             fmt::format("each once of {}", joined(names_with_hidden(), ", ")), "solids",
             [&s](const std::string& text) {
               s.hidden_layers = split(text, ',');
               return are_among(names_with_hidden(), s.hidden_layers);
             })
      .words(names_with_hidden());
}

void add_scene_options(std::vector<Option>& options, RenderSettings& s) {
  OptionGroup group(options, "Solids");
  group
      .name("--scene FILE",
            "Huts, towers, masts and the like on the terrain (docs/scenes.md); a scene as INPUT is "
            "drawn alone",
            "a scene in TOML", "", s.scene_file)
      .files({"toml"});
}

} // namespace orograph
