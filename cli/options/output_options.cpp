// SPDX-License-Identifier: GPL-3.0-or-later
// What a drawing is written as, and what is told of it.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_kinds.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orograph {
namespace {

constexpr auto kGroup = "Output";

} // namespace

void add_output_options(std::vector<Option>& options, RenderSettings& s) {
  const std::string formats = fmt::format("{}", fmt::join(format_names(), ", "));
  options.push_back({.group = kGroup,
                     .name = "--of",
                     .value = "FORMAT",
                     .help = "Format of OUTPUT",
                     .allowed = "one of " + formats,
                     .by_default = "by OUTPUT's extension",
                     .take = [&s](const std::string& text) {
                       s.write.format = format_of_name(text);
                       return true;
                     }});
  options.push_back(with_number({.group = kGroup,
                                 .name = "--dpi",
                                 .value = "N",
                                 .help = "Resolution of PNG",
                                 .by_default = fmt::format("{}", s.write.dpi)},
                                {.unit = "dots per inch", .low = 10, .high = 4800},
                                [&s](double dpi) { s.write.dpi = dpi; }));
  options.push_back({.group = kGroup,
                     .name = "--overwrite",
                     .help = "Replace OUTPUT and the report where they exist",
                     .take = set_to(s.write.overwrite, true)});
  options.push_back(
      {.group = kGroup,
       .name = "--report",
       .value = "FILE.json|FILE.toml",
       .help = "Write what was drawn, how exactly and in which time; to a .toml the view alone, "
               "as --view takes it",
       .allowed = "a file name",
       .take = stored_name(s.report)});
  options.push_back(with_integer({.group = kGroup,
                                  .name = "--check",
                                  .value = "N",
                                  .help = "Ask N random points of the drawing of a ray walk over "
                                          "the terrain, and tell how many are drawn wrongly",
                                  .by_default = "0"},
                                 0, 100000000,
                                 [&s](int n) { s.map.check = static_cast<unsigned>(n); }));
}

} // namespace orograph
