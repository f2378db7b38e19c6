// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/options/suggest_option.hpp"

#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace orograph {
namespace {

constexpr std::string_view kBoth = "azimuth and elevation";
constexpr std::string_view kLight = "where light falls from";
constexpr std::string_view kNoGround = "lines have colours (--colour), and the ground none";

// Words of GMT and PyGMT, PLplot, gnuplot, matplotlib, GRASS, QGIS, rayshader, ridge_map and GDAL.
constexpr auto kWords = std::to_array<OtherWord>({
    // Where the viewer is
    {"azimuth", "--view-from", kBoth},
    {"azim", "--view-from", kBoth},
    {"elevation", "--view-from", kBoth},
    {"elev", "--view-from", kBoth},
    {"altitude", "--view-from", kBoth},
    {"angle", "--view-from", kBoth},
    {"tilt", "--view-from", kBoth},
    {"theta", "--view-from", kBoth},
    {"phi", "--view-from", kBoth},
    {"rotation", "--view-from", kBoth},
    {"viewpoint", "--view-from", kBoth},
    {"viewpoint-elevation", "--view-from", kBoth},
    {"view-azimuth", "--view-from", kBoth},
    {"view-elevation", "--view-from", kBoth},
    {"view-angle", "--view-from", kBoth},
    {"view-init", "--view-from", kBoth},
    {"perspective", "--view-from", "--projection perspective is the default"},
    {"from", "--view-from", {}},
    {"view-from", "--azimuth", "and --elevation"}, // of a sweep
    {"direction", "--view-from", kBoth},
    {"camera", "--eye", {}},
    {"position", "--eye", {}},
    {"observer", "--eye", {}},
    {"observer-height", "--eye-height", {}},
    {"camera-height", "--eye-height", {}},
    {"target", "--look-at", {}},
    {"target-elevation", "--target-height", {}},
    {"observer-elevation", "--eye-height", {}},
    {"horizon", "--horizon-table", {}},
    {"focus", "--look-at", {}},
    {"centre", "--look-at", {}},
    {"center", "--look-at", {}},
    {"heading", "--look-azimuth", {}},
    {"bearing", "--look-azimuth", {}},
    {"yaw", "--look-azimuth", {}},
    {"zoom", "--fov", {}},
    {"field-of-view", "--fov", {}},
    {"orthographic", "--projection", {}},
    {"ortho", "--projection", {}},
    {"parallel", "--projection", "orthographic and oblique are parallel"},
    {"isometric", "--axonometric", {}},
    {"cavalier", "--oblique", {}},
    {"cabinet", "--oblique", {}},
    {"military", "--oblique", {}},
    {"curvature-refraction", "--refraction", {}},
    {"earth-curvature", "--curvature", {}},
    {"panorama", "--projection", "cylindrical goes all round"},
    {"cylindrical", "--projection", {}},
    // Heights
    {"jz", "--exaggeration", {}},
    {"zscale", "--exaggeration", {}},
    {"z-scale", "--exaggeration", {}},
    {"zsize", "--exaggeration", {}},
    {"zexag", "--exaggeration", {}},
    {"zfactor", "--exaggeration", {}},
    {"z-factor", "--exaggeration", {}},
    {"vertical-exaggeration", "--exaggeration", {}},
    {"vertical-scale", "--exaggeration", {}},
    {"vertical-ratio", "--exaggeration", {}},
    {"height-scale", "--exaggeration", {}},
    {"raise", "--exaggeration", {}},
    {"max-error", "--level-error", {}},
    {"error", "--level-error", {}},
    {"lod", "--detail", "--level-error bounds what it changes"},
    // Lines
    {"lines", "--profiles", {}},
    {"num-lines", "--profiles", {}},
    {"line-count", "--profiles", {}},
    {"sections", "--profiles", {}},
    {"step", "--spacing", {}},
    {"interval", "--spacing", {}},
    {"line-spacing", "--spacing", {}},
    {"density", "--spacing", {}},
    {"hidden3d", "--occluder", "hidden lines are always gone"},
    {"wireframe", "--layers", "edges are those of the terrain's triangles"},
    {"outlines", "--layers", {}},
    {"water", "--flat", {}},
    {"sea", "--flat", {}},
    {"lakes", "--flat", {}},
    {"lake-flatness", "--flat", {}},
    {"smooth", "--simplify", {}},
    {"tolerance", "--simplify", {}},
    {"contour", "--contours", {}},
    {"contour-interval", "--contours", {}},
    {"isolines", "--contours", {}},
    {"levels", "--contours", {}},
    {"hatching", "--hachures", {}},
    {"underneath", "--underside", {}},
    {"bottom", "--underside", {}},
    {"facade", "--block", {}},
    {"skirt", "--block", {}},
    {"fishnet", "--mesh", {}},
    {"meridians", "--graticule", {}},
    {"roads", "--drape", {}},
    {"rivers", "--drape", {}},
    {"vector", "--drape", {}},
    {"overlay", "--drape", {}},
    {"label", "--labels", {}},
    {"names", "--labels", {}},
    {"peaks", "--labels", {}},
    {"summits", "--labels", {}},
    {"places", "--labels", {}},
    // Light
    {"hillshade", "--light", kLight},
    {"shade", "--light", kLight},
    {"shading", "--light", kLight},
    {"shadow", "--light", kLight},
    {"sun", "--light", kLight},
    {"sun-azimuth", "--light", kLight},
    {"sun-altitude", "--light", kLight},
    {"sun-angle", "--light", kLight},
    {"illumination", "--light", kLight},
    {"lighting", "--light", kLight},
    {"relief", "--light", kLight},
    {"az", "--light", "--view-from is where the viewer stands"},
    {"alt", "--light", "--view-from is where the viewer stands"},
    {"fog", "--haze", {}},
    {"fade", "--haze", {}},
    {"atmosphere", "--haze", {}},
    // Pen and page
    {"width", "--pen-width", "--page is the paper's size"},
    {"stroke-width", "--pen-width", {}},
    {"line-width", "--pen-width", {}},
    {"linewidth", "--pen-width", {}},
    {"lw", "--pen-width", {}},
    {"pen", "--pen-width", {}},
    {"thickness", "--pen-width", {}},
    {"size", "--page", {}},
    {"paper", "--page", {}},
    {"paper-size", "--page", {}},
    {"figsize", "--page", {}},
    {"height", "--page", "--eye-height is an eye's"},
    {"orientation", "--landscape", "or --portrait"},
    {"padding", "--margin", {}},
    {"border", "--margin", "--layers border draws where the terrain ends"},
    {"caption", "--title", {}},
    {"color", "--colour", {}},
    {"colors", "--colour", {}},
    {"line-color", "--colour", {}},
    {"stroke", "--colour", {}},
    {"cmap", {}, kNoGround},
    {"background", {}, kNoGround},
    // Terrain
    {"region", "--bbox", {}},
    {"extent", "--bbox", {}},
    {"bounds", "--bbox", {}},
    {"window", "--bbox", {}},
    {"clip", "--bbox", {}},
    {"projwin", "--bbox", {}},
    {"spat", "--bbox", {}},
    {"resolution", "--overview", "--dpi is that of PNG"},
    {"downsample", "--overview", {}},
    {"nodata", "--fill-voids", {}},
    {"fill-nodata", "--fill-voids", {}},
    {"units", "--height-unit", {}},
    {"dem", "INPUT", "named without an option"},
    {"input", "INPUT", "named without an option"},
    {"crs", {}, "the terrain is drawn in its own CRS; gdalwarp brings it into another"},
    {"epsg", {}, "the terrain is drawn in its own CRS; gdalwarp brings it into another"},
    {"t-srs", {}, "the terrain is drawn in its own CRS; gdalwarp brings it into another"},
    // Output
    {"o", "OUTPUT", "named without an option"},
    {"out", "OUTPUT", "named without an option"},
    {"output", "OUTPUT", "named without an option"},
    {"outfile", "OUTPUT", "named without an option"},
    {"format", "--of", {}},
    {"output-format", "--of", {}},
    {"driver", "--of", {}},
    {"force", "--overwrite", {}},
    {"verbose", "--report", {}},
    {"threads", "--jobs", {}},
    {"cores", "--jobs", {}},
    {"config", "--settings", {}},
    {"style", "--settings", {}},
    {"preset", "--settings", {}},
    // Short options, with their values behind them: GMT's -p225/30, gdal_viewshed's -ox 3
    {"-jz", "--exaggeration", {}},
    {"-p", "--view-from", {}},
    {"-r", "--bbox", {}},
    {"-w", "--pen-width", {}},
    {"-i", "--light", {}},
    {"-te", "--bbox", {}},
    {"-tr", "--overview", {}},
    {"-ox", "--eye", {}},
    {"-oy", "--eye", {}},
    {"-oz", "--eye-height", {}},
    {"-cc", "--curvature-coefficient", {}},
    {"-tz", "--target-height", {}},
    {"-o", "OUTPUT", "named without an option"},
    {"-f", "--of", {}},
    {"-z", "--exaggeration", {}},
    {"-s", "--exaggeration", {}},
});

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
  for (const OtherWord& word : kWords) {
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

std::span<const OtherWord> other_words() {
  return kWords;
}

std::string suggestion(const Command& command, std::string_view name) {
  const std::string written = plain(name), given = without_dashes(written);
  if (const OtherWord* word = short_word(command, written)) return told(command, *word);
  for (const OtherWord& word : kWords)
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
    if (is_nearer(known, begins ? 0 : edit_distance(given, known))) nearest = &option;
  }
  for (const OtherWord& word : kWords) {
    const int distance = edit_distance(given, word.word);
    // There are many words: short ones are near to anything.
    if (distance <= 2 && word.word.size() > 5 && is_of_use(word, command) &&
        is_nearer(word.word, distance))
      nearest_word = &word;
  }
  if (nearest_word != nullptr) return told(command, *nearest_word);
  return nearest != nullptr ? fmt::format("did you mean {}?", nearest->name) : "";
}

} // namespace orograph
