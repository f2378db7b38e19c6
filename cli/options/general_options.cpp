// SPDX-License-Identifier: GPL-3.0-or-later
// What every command, or every one that draws, takes.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_kinds.hpp"

namespace orograph {
namespace {

constexpr auto kGroup = "General";

} // namespace

Option help_option() {
  return {.group = kGroup,
          .name = "--help",
          .letter = 'h',
          .help = "Show this and do nothing else",
          .take = [](const std::string&) { return true; }};
}

Option quiet_option(bool& quiet) {
  return {.group = kGroup,
          .name = "--quiet",
          .letter = 'q',
          .help = "Only errors on stderr",
          .take = set_to(quiet, true)};
}

Option jobs_option(int& jobs) {
  return with_integer({.group = kGroup,
                       .name = "--jobs",
                       .letter = 'j',
                       .value = "N",
                       .help = "Cores to use, which changes nothing but the time",
                       .by_default = "all"},
                      1, 1024, [&jobs](int n) { jobs = n; });
}

void add_general_options(std::vector<Option>& options, bool& quiet, std::optional<bool>& progress) {
  options.push_back(quiet_option(quiet));
  options.push_back({.group = kGroup,
                     .name = "--progress",
                     .help = "Show the progress on stderr, the default on a terminal",
                     .take = set_to(progress, true)});
  options.push_back({.group = kGroup,
                     .name = "--no-progress",
                     .help = "Don't show it",
                     .take = set_to(progress, false)});
  options.push_back(help_option());
}

} // namespace orograph
