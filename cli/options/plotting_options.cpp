// SPDX-License-Identifier: GPL-3.0-or-later
// Pens, and paper that a map doesn't fit on.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"

#include <fmt/format.h>

namespace orograph {
void add_plotting_options(std::vector<Option>& options, RenderSettings& s) {
  constexpr auto kGroup = "Plotting";
  options.push_back(
      {.group = kGroup,
       .name = "--pens",
       .value = "FILE",
       .help =
           "Draw with these pens: a TOML file with width, colour, dash, number, speed and height "
           "of each, and what it draws: layers, or lines of --drape by a field "
           "(docs/plotters.md). Where several of them draw profiles, light is shown by their "
           "widths",
       .allowed = "a file name",
       .extensions = {"toml"},
       .take = stored_name(s.pens_file)});
  options.push_back({.group = kGroup,
                     .name = "--pause-between-pens",
                     .help = "Have the plotter wait for a hand before each pen but the first",
                     .take = set_to(s.pause_between_pens, true)});
  options.push_back({.group = kGroup,
                     .name = "--clip-to",
                     .value = "WIDTHxHEIGHT",
                     .help = "Cut lines at a rectangle of this size in the page's middle",
                     .allowed = "width x height in mm such as 270x190, each 1 to 10000",
                     .by_default = "the page inside of its margins",
                     .between = 'x',
                     .take = [&s](const std::string& text) {
                       const auto size = parse_page_size(text);
                       if (!size || !size->height_mm) return false;
                       s.clip_to_mm = Vec2{size->width_mm, *size->height_mm};
                       return true;
                     }});
  options.push_back({.group = kGroup,
                     .name = "--sheets",
                     .value = "COLUMNSxROWS",
                     .help =
                         "Draw the map over so many sheets of the size of --page, upright where it "
                         "is named, unless --landscape, with register marks: OUTPUT map.svg is "
                         "map-1.svg and so on, and map-overview.svg",
                     .allowed = "columns x rows such as 2x3, each 1 to 20",
                     .by_default = "one sheet",
                     .between = 'x',
                     .take = stored(parse_sheets, s.sheets)});
  options.push_back({.group = kGroup,
                     .name = "--overlap",
                     .value = "MM",
                     .help = "What neighbouring sheets both show",
                     .allowed = "mm, 0 to 1000",
                     .by_default = fmt::format("{}", s.overlap_mm),
                     .take = [&s](std::string text) {
                       if (text.ends_with("mm")) text.resize(text.size() - 2);
                       const auto mm = parse_number(text);
                       if (!mm || *mm < 0 || *mm > 1000) return false;
                       s.overlap_mm = *mm;
                       return true;
                     }});
}

} // namespace orograph
