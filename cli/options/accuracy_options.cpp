// SPDX-License-Identifier: GPL-3.0-or-later
// What `orograph accuracy` measures.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_kinds.hpp"
#include "cli/options/option_values.hpp"

#include <fmt/format.h>

#include <charconv>

namespace orograph {
namespace {

constexpr auto kGroup = "Measures", kOutput = "Output";
constexpr int kMostProfiles = 100000;

// "60,150,rows"
std::optional<std::vector<std::optional<int>>> parse_counts(const std::string& text) {
  std::vector<std::optional<int>> counts;
  for (const std::string& part : split(text, ',')) {
    if (part == "rows") {
      counts.emplace_back();
      continue;
    }
    int count = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), count);
    if (error != std::errc() || end != part.data() + part.size() || count < 1 ||
        count > kMostProfiles)
      return std::nullopt;
    counts.emplace_back(count);
  }
  return counts;
}

} // namespace

void add_accuracy_options(std::vector<Option>& options, AccuracySettings& s) {
  options.push_back({.group = kGroup,
                     .name = "--profiles",
                     .value = "LIST",
                     .help = "Numbers of profiles to compare; all else is varied at the middle one",
                     .allowed = fmt::format("whole numbers, 1 to {}, or rows for one to each row "
                                            "of the grid, with commas between",
                                            kMostProfiles),
                     .by_default = "60,150,300,rows",
                     .take = stored(parse_counts, s.profiles)});
  options.push_back(with_integer({.group = kGroup,
                                  .name = "--probes",
                                  .value = "N",
                                  .help = "Random points of each row's profiles to ask of the ray "
                                          "walk, and as many to each mm of its other lines",
                                  .by_default = std::to_string(s.probes)},
                                 100, 100000000, [&s](int n) { s.probes = n; }));
  options.push_back(with_integer({.group = kGroup,
                                  .name = "--repeats",
                                  .value = "N",
                                  .help = "Runs to time for each row; the fastest counts",
                                  .by_default = std::to_string(s.repeats)},
                                 1, 1000, [&s](int n) { s.repeats = n; }));
  options.push_back({.group = kOutput,
                     .name = "--output",
                     .value = "PREFIX",
                     .help = "Write PREFIX.csv, PREFIX.json and the curve, PREFIX.svg",
                     .allowed = "a file name without extension",
                     .by_default = s.prefix,
                     .take = stored_name(s.prefix)});
  options.push_back({.group = kOutput,
                     .name = "--overwrite",
                     .help = "Replace these files where they exist",
                     .take = set_to(s.render.write.overwrite, true)});
}

} // namespace orograph
