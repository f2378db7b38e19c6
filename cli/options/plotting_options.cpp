// SPDX-License-Identifier: GPL-3.0-or-later
// Pens, and paper that a map doesn't fit on.
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/option_values.hpp"
#include "text/quantities.hpp"

#include <fmt/format.h>

namespace orograph {
void add_plotting_options(std::vector<Option>& options, RenderSettings& s) {
  OptionGroup group(options, "Plotting");
  group
      .name(
          "--pens FILE",
          "Draw with these pens: a TOML file with width, colour, dash, number, speed and height of "
          "each, and what it draws: layers, or lines of --drape by a field (docs/plotters.md). "
          "Where several of them draw profiles, light is shown by their widths",
          "a file name", "", s.pens_file)
      .files({"toml"});
  group.flag("--pause-between-pens",
             "Have the plotter wait for a hand before each pen but the first",
             s.pause_between_pens);
  group
      .value("--clip-to WIDTHxHEIGHT", "Cut lines at a rectangle of this size in the page's middle",
             "width x height in mm such as 270x190, each 1 to 10000",
             "the page inside of its margins",
             [&s](const std::string& text) {
               const auto size = parse_page_size(text);
               if (!size || !size->height_mm) return false;
               s.clip_to_mm = Vec2{size->width_mm, *size->height_mm};
               return true;
             })
      .between('x');
  group
      .parsed("--sheets COLUMNSxROWS",
              "Draw the map over so many sheets of the size of --page, upright where it is named, "
              "unless --landscape, with register marks: OUTPUT map.svg is map-1.svg and so on, and "
              "map-overview.svg",
              "columns x rows such as 2x3, each 1 to 20", "one sheet", parse_sheets, s.sheets)
      .between('x');
  group.value("--overlap MM", "What neighbouring sheets both show", "mm, 0 to 1000",
              fmt::format("{}", s.overlap_mm), [&s](std::string text) {
                if (text.ends_with("mm")) text.resize(text.size() - 2);
                const auto mm = parse_number(text);
                if (!mm || *mm < 0 || *mm > 1000) return false;
                s.overlap_mm = *mm;
                return true;
              });
}

} // namespace orograph
