// SPDX-License-Identifier: GPL-3.0-or-later
// What `tin` makes.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_kinds.hpp"
#include "cli/options/option_values.hpp"

#include <map>

namespace orograph {
namespace {

constexpr auto kGroup = "Output";

} // namespace

void add_tin_options(std::vector<Option>& options, TinSettings& settings) {
  options.push_back({.group = kGroup,
                     .name = "--max-error",
                     .value = "LENGTH",
                     .help = "Of a raster: keep as few of its vertices as leave the TIN nowhere "
                             "farther from it in height",
                     .allowed = "a length from 0 on with its unit, such as 2m",
                     .take = stored(parse_metres, settings.max_error_m)});
  std::optional<TinFormat>& format = settings.format;
  const std::map<std::string, TinFormat> formats{{"gpkg", TinFormat::gpkg},
                                                 {"off", TinFormat::off},
                                                 {"ply", TinFormat::ply},
                                                 {"obj", TinFormat::obj}};
  options.push_back({.group = kGroup,
                     .name = "--of",
                     .value = "gpkg|off|ply|obj",
                     .help = "Format of OUTPUT",
                     .by_default = "by its extension",
                     .take = [formats, &format](const std::string& text) {
                       const auto found = formats.find(text);
                       if (found == formats.end()) return false;
                       format = found->second;
                       return true;
                     }});
  options.push_back({.group = kGroup,
                     .name = "--overwrite",
                     .help = "Replace an existing file",
                     .take = set_to(settings.overwrite, true)});
  options.push_back(jobs_option(settings.jobs));
  options.push_back(quiet_option(settings.quiet));
  options.push_back(help_option());
}

} // namespace orograph
