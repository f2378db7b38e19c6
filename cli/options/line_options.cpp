// SPDX-License-Identifier: GPL-3.0-or-later
// Which lines are drawn, and how exactly.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_kinds.hpp"
#include "cli/options/option_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace orograph {
namespace {

constexpr auto kGroup = "Profiles and lines";
const std::array<std::string, 8> kLayerNames{"profiles", "edges",       "shores",  "border",
                                             "voids",    "silhouettes", "skyline", "solids"};

} // namespace

void add_line_options(std::vector<Option>& options, RenderSettings& s) {
  options.push_back(with_integer({.group = kGroup,
                                  .name = "--profiles",
                                  .value = "N",
                                  .help = "Number of profiles",
                                  .by_default = "as many as --spacing gives"},
                                 1, 100000, [&s](int n) { s.plan = ProfileCount{n}; }));
  options.push_back({.group = kGroup,
                     .name = "--spacing",
                     .value = "LENGTH",
                     .help = "Distance between profiles: on the page for level ground, or on the "
                             "ground in depth",
                     .allowed = "a length above 0 with its unit, 0.6mm on the page or 100m on the "
                                "ground",
                     .by_default = "four pen widths on the page",
                     .take = stored(parse_spacing, s.plan)});
  options.push_back(with_choice<Occluder>(
      {.group = kGroup,
       .name = "--occluder",
       .help = "What hides: the whole surface, exactly, or only the profiles drawn",
       .by_default = "surface"},
      {{"surface", Occluder::surface}, {"profiles", Occluder::profiles}}, s.occluder));
  options.push_back(with_number({.group = kGroup,
                                 .name = "--visibility-tolerance",
                                 .value = "MM",
                                 .help = "Lines that lie this close to the horizon, on the page, "
                                         "count as tied with it and are drawn once; 0 compares "
                                         "exactly",
                                 .by_default = fmt::format("{}", s.visibility_tolerance_mm)},
                                {.unit = "mm", .low = 0, .high = 10},
                                [&s](double mm) { s.visibility_tolerance_mm = mm; }));
  options.push_back(with_number({.group = kGroup,
                                 .name = "--simplify",
                                 .value = "MM",
                                 .help = "Largest displacement of a line when points are left out; "
                                         "0 keeps all",
                                 .by_default = fmt::format("{}", s.simplify_mm)},
                                {.unit = "mm", .low = 0, .high = 10},
                                [&s](double mm) { s.simplify_mm = mm; }));
  options.push_back(
      with_number({.group = kGroup,
                   .name = "--silhouette-jump",
                   .value = "SHARE",
                   .help = "Draw a silhouette only where the ground behind is farther "
                           "by more than this share of the depth; 0 draws all",
                   .by_default = fmt::format("{}", s.silhouette_jump)},
                  {.low = 0, .high = 10}, [&s](double share) { s.silhouette_jump = share; }));
  options.push_back(with_number({.group = kGroup,
                                 .name = "--min-stroke",
                                 .value = "MM",
                                 .help = "Leave out visible strokes shorter than this",
                                 .by_default = fmt::format("{}", s.min_stroke_mm)},
                                {.unit = "mm", .low = 0, .high = 1000},
                                [&s](double mm) { s.min_stroke_mm = mm; }));
  options.push_back(with_choice<FlatGround>(
      {.group = kGroup,
       .name = "--flat",
       .help = "Level ground such as sea and lakes: only its shores, or its profiles too",
       .by_default = "shore"},
      {{"shore", FlatGround::shore}, {"draw", FlatGround::draw}}, s.flat));
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
                     .allowed = fmt::format("each once of {}", fmt::join(kLayerNames, ", ")),
                     .by_default = fmt::format("{}", fmt::join(s.layers, ",")),
                     .take = [&s](const std::string& text) {
                       s.layers = split(text, ',');
                       return std::all_of(s.layers.begin(), s.layers.end(), [&](const auto& layer) {
                         return std::count(s.layers.begin(), s.layers.end(), layer) == 1 &&
                                std::count(kLayerNames.begin(), kLayerNames.end(), layer) == 1;
                       });
                     }});
}

} // namespace orograph
