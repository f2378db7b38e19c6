// SPDX-License-Identifier: GPL-3.0-or-later
// The paper and the pen.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_kinds.hpp"
#include "cli/options/option_values.hpp"
#include "draw/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orograph {
namespace {

constexpr auto kGroup = "Page";

} // namespace

void add_page_options(std::vector<Option>& options, RenderSettings& s) {
  options.push_back({.group = kGroup,
                     .name = "--page",
                     .value = "NAME|WxH",
                     .help = "Paper; a named one is turned to the picture's shape",
                     .allowed = fmt::format("one of {}, or width x height in mm such as 400x250, "
                                            "each 1 to 10000",
                                            fmt::join(paper_names(), ", ")),
                     .by_default = "a4",
                     .take = [&page = s.map.page](const std::string& text) {
                       const auto named = paper_size_mm(text);
                       const auto size = named ? named : parse_width_x_height(text);
                       if (!size) return false;
                       page.width_mm = size->x;
                       page.height_mm = size->y;
                       if (!named && page.orientation == Orientation::by_picture)
                         page.orientation = Orientation::as_given;
                       return true;
                     }});
  options.push_back({.group = kGroup,
                     .name = "--portrait",
                     .help = "Page upright",
                     .take = set_to(s.map.page.orientation, Orientation::portrait)});
  options.push_back({.group = kGroup,
                     .name = "--landscape",
                     .help = "Page on its side",
                     .take = set_to(s.map.page.orientation, Orientation::landscape)});
  options.push_back(with_number({.group = kGroup,
                                 .name = "--margin",
                                 .value = "MM",
                                 .help = "Empty paper on each side",
                                 .by_default = fmt::format("{}", s.map.page.margin_mm)},
                                {.unit = "mm", .low = 0},
                                [&s](double mm) { s.map.page.margin_mm = mm; }));
  options.push_back(with_number({.group = kGroup,
                                 .name = "--pen-width",
                                 .value = "MM",
                                 .help = "Width of the pen that draws the profiles",
                                 .by_default = fmt::format("{}", s.map.style.pen_width_mm)},
                                {.unit = "mm", .low = 0.01, .high = 10},
                                [&s](double mm) { s.map.style.pen_width_mm = mm; }));
  options.push_back({.group = kGroup,
                     .name = "--title",
                     .value = "TEXT",
                     .help = "Title in the file's metadata",
                     .by_default = "INPUT's file name",
                     .take = [&s](const std::string& text) {
                       s.map.title = text;
                       return true;
                     }});
}

} // namespace orograph
