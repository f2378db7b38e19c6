// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options/suggest_option.hpp"

#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace orograph {
namespace {

constexpr std::string_view kBoth = "azimuth and elevation";
constexpr std::string_view kLight = "where light falls from";
constexpr std::string_view kNoGround = "lines have colours (--colour), and the ground none";

// What is meant by several words, which have a blank between: as in `OtherWord`.
struct WordsOfOthers {
  std::string_view option, says, words;
};

// Words of GMT and PyGMT, PLplot, gnuplot, matplotlib, GRASS, QGIS, rayshader, ridge_map and GDAL.
constexpr auto kWords = std::to_array<WordsOfOthers>({
    // Where the viewer is
    {"--view-from", kBoth,
     "azimuth azim elevation elev altitude angle tilt theta phi rotation viewpoint "
     "viewpoint-elevation view-azimuth view-elevation view-angle view-init direction"},
    {"--view-from", "--projection perspective is the default", "perspective"},
    {"--view-from", {}, "from"},
    {"--azimuth", "and --elevation", "view-from"}, // of a sweep
    {"--eye", {}, "camera position observer"},
    {"--eye-height", {}, "observer-height camera-height observer-elevation"},
    {"--look-at", {}, "target focus centre center"},
    {"--target-height", {}, "target-elevation"},
    {"--horizon-table", {}, "horizon"},
    {"--look-azimuth", {}, "heading bearing yaw"},
    {"--fov", {}, "zoom field-of-view"},
    {"--projection", {}, "orthographic ortho cylindrical"},
    {"--projection", "orthographic and oblique are parallel", "parallel"},
    {"--axonometric", {}, "isometric"},
    {"--oblique", {}, "cavalier cabinet military"},
    {"--refraction", {}, "curvature-refraction"},
    {"--curvature", {}, "earth-curvature"},
    {"--projection", "cylindrical goes all round", "panorama"},
    // Heights
    {"--exaggeration",
     {},
     "jz zscale z-scale zsize zexag zfactor z-factor vertical-exaggeration vertical-scale "
     "vertical-ratio height-scale raise"},
    {"--level-error", {}, "max-error error"},
    {"--detail", "--level-error bounds what it changes", "lod"},
    // Lines
    {"--profiles", {}, "lines num-lines line-count sections"},
    {"--spacing", {}, "step interval line-spacing density"},
    {"--occluder", "hidden lines are always gone", "hidden3d"},
    {"--layers", "edges are those of the terrain's triangles", "wireframe"},
    {"--layers", {}, "outlines"},
    {"--flat", {}, "water sea lakes lake-flatness"},
    {"--simplify", {}, "smooth tolerance"},
    {"--contours", {}, "contour contour-interval isolines levels"},
    {"--hachures", {}, "hatching"},
    {"--underside", {}, "underneath bottom"},
    {"--block", {}, "facade skirt"},
    {"--mesh", {}, "fishnet"},
    {"--graticule", {}, "meridians"},
    {"--drape", {}, "roads rivers vector overlay"},
    {"--labels", {}, "label names peaks summits places"},
    // Light
    {"--light", kLight,
     "hillshade shade shading shadow sun sun-azimuth sun-altitude sun-angle illumination lighting "
     "relief"},
    {"--light", "--view-from is where the viewer stands", "az alt"},
    {"--haze", {}, "fog fade atmosphere"},
    // Pen and page
    {"--pen-width", "--page is the paper's size", "width"},
    {"--pen-width", {}, "stroke-width line-width linewidth lw pen thickness"},
    {"--page", {}, "size paper paper-size figsize"},
    {"--page", "--eye-height is an eye's", "height"},
    {"--landscape", "or --portrait", "orientation"},
    {"--margin", {}, "padding"},
    {"--margin", "--layers border draws where the terrain ends", "border"},
    {"--title", {}, "caption"},
    {"--colour", {}, "color colors line-color stroke"},
    {{}, kNoGround, "cmap background"},
    // Terrain
    {"--bbox", {}, "region extent bounds window clip projwin spat"},
    {"--overview", "--dpi is that of PNG", "resolution"},
    {"--overview", {}, "downsample"},
    {"--fill-voids", {}, "nodata fill-nodata"},
    {"--height-unit", {}, "units"},
    {"INPUT", "named without an option", "dem input"},
    {{}, "the terrain is drawn in its own CRS; gdalwarp brings it into another", "crs epsg t-srs"},
    // Output
    {"OUTPUT", "named without an option", "o out output outfile"},
    {"--of", {}, "format output-format driver"},
    {"--overwrite", {}, "force"},
    {"--report", {}, "verbose"},
    {"--jobs", {}, "threads cores"},
    {"--settings", {}, "config style preset"},
    // Short options, with their values behind them: GMT's -p225/30, gdal_viewshed's -ox 3
    {"--exaggeration", {}, "-jz -z -s"},
    {"--view-from", {}, "-p"},
    {"--bbox", {}, "-r -te"},
    {"--pen-width", {}, "-w"},
    {"--light", {}, "-i"},
    {"--overview", {}, "-tr"},
    {"--eye", {}, "-ox -oy"},
    {"--eye-height", {}, "-oz"},
    {"--curvature-coefficient", {}, "-cc"},
    {"--target-height", {}, "-tz"},
    {"OUTPUT", "named without an option", "-o"},
    {"--of", {}, "-f"},
});

} // namespace

const std::vector<OtherWord>& other_words() {
  static const std::vector<OtherWord> all = [] {
    std::vector<OtherWord> each;
    for (const auto& [option, says, words] : kWords)
      for (std::string& word : split(words, ' ')) each.push_back({std::move(word), option, says});
    return each;
  }();
  return all;
}

namespace {

// In the words' way of writing.
std::string plain(std::string_view name) {
  std::string word = in_lower_case(name);
  std::replace(word.begin(), word.end(), '_', '-');
  return word;
}

std::string without_dashes(std::string_view name) {
  name.remove_prefix(std::min(name.find_first_not_of('-'), name.size()));
  return std::string(name);
}

const Option* option_named(const Command& command, std::string_view name) {
  for (const Option& option : command.options)
    if (option.name == name) return &option;
  return nullptr;
}

// A word is of use where it has no option, or one of the command's.
bool is_of_use(const OtherWord& word, const Command& command) {
  return word.option.empty() || option_named(command, word.option) != nullptr;
}

const OtherWord* short_word(const Command& command, std::string_view given) {
  if (given.size() < 2 || given[0] != '-' || given[1] == '-') return nullptr;
  for (const OtherWord& word : other_words()) {
    if (!word.word.starts_with('-') || !is_of_use(word, command)) continue;
    // What follows is its value: a number, or a short word as in -JZ5c.
    if (given == word.word ||
        (given.starts_with(word.word) && given.find_first_of("0123456789") < given.size()))
      return &word;
  }
  return nullptr;
}

std::string told(const Command& command, const OtherWord& word) {
  if (word.option.empty()) return std::string(word.says);
  const Option& option = *option_named(command, word.option);
  const std::string says = word.says.empty() ? "" : fmt::format(" ({})", word.says);
  return fmt::format("did you mean {}{}{}{}?", option.name, option.value.empty() ? "" : " ",
                     option.value, says);
}

} // namespace

std::string suggestion(const Command& command, std::string_view name) {
  const std::string written = plain(name), given = without_dashes(written);
  if (const OtherWord* word = short_word(command, written)) return told(command, *word);
  for (const OtherWord& word : other_words())
    if (word.word == given && is_of_use(word, command)) return told(command, word);
  const Option* nearest = nullptr;
  const OtherWord* nearest_word = nullptr;
  int least = 4; // farther than that, a suggestion is a guess
  // A word of three letters is within 3 edits of any other.
  const auto is_nearer = [&](std::string_view known, int distance) {
    if (distance >= least || distance >= static_cast<int>(known.size())) return false;
    least = distance;
    return true;
  };
  for (const Option& option : command.options) {
    if (option.is_positional()) continue;
    const std::string known = without_dashes(option.name);
    const bool begins = known.starts_with(given) && given.size() > 1;
    if (is_nearer(known, begins ? 0 : edit_distance(given, known, least))) nearest = &option;
  }
  for (const OtherWord& word : other_words()) {
    const int distance = edit_distance(given, word.word, 3);
    // There are many words: short ones are near to anything.
    if (distance <= 2 && word.word.size() > 5 && is_of_use(word, command) &&
        is_nearer(word.word, distance))
      nearest_word = &word;
  }
  if (nearest_word != nullptr) return told(command, *nearest_word);
  return nearest != nullptr ? fmt::format("did you mean {}?", nearest->name) : "";
}

} // namespace orograph
