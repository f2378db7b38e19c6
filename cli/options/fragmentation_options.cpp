// SPDX-License-Identifier: GPL-3.0-or-later
// What `orograph fragmentation` measures.
#include "cli/options/option_groups.hpp"
#include "cli/options/option_kinds.hpp"
#include "cli/options/option_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

namespace orograph {
namespace {

constexpr auto kGroup = "Measures", kOutput = "Output";
constexpr int kMostProfiles = 100000, kLargestWorstCase = 10000;

// Values with commas between, each read by `parse` and allowed by `allows`.
template <class Number, class Parse, class Allows>
auto list_of(Parse parse, Allows allows) {
  return [=](const std::string& text) -> std::optional<std::vector<Number>> {
    std::vector<Number> numbers;
    for (const std::string& part : split(text, ',')) {
      const auto number = parse(part);
      if (!number || !allows(*number)) return std::nullopt;
      numbers.push_back(*number);
    }
    return numbers;
  };
}

} // namespace

void add_fragmentation_options(std::vector<Option>& options, FragmentationSettings& s) {
  options.push_back(
      {.group = kGroup,
       .name = "--profiles",
       .value = "LIST",
       .help = "Numbers of profiles",
       .allowed = fmt::format("whole numbers, 1 to {}, with commas between", kMostProfiles),
       .by_default = fmt::format("{}", fmt::join(s.profiles, ",")),
       .take =
           stored(list_of<int>(parse_integer, [](int n) { return n >= 1 && n <= kMostProfiles; }),
                  s.profiles)});
  options.push_back(
      {.group = kGroup,
       .name = "--elevations",
       .value = "LIST",
       .help = "Where the viewer stands above the horizontal",
       .allowed = "degrees, 0 to 90, with commas between",
       .by_default = fmt::format("{}", fmt::join(s.elevations_deg, ",")),
       .take =
           stored(list_of<double>(parse_number, [](double deg) { return deg >= 0 && deg <= 90; }),
                  s.elevations_deg)});
  options.push_back(
      {.group = kGroup,
       .name = "--azimuths",
       .value = "LIST",
       .help = "Where the viewer stands, clockwise from north; profiles run across: along the rows "
               "of a grid from 180, along its columns from 90",
       .allowed = "degrees, -360 to 360, with commas between",
       .by_default = fmt::format("{}", fmt::join(s.azimuths_deg, ",")),
       .take = stored(
           list_of<double>(parse_number, [](double deg) { return deg >= -360 && deg <= 360; }),
           s.azimuths_deg)});
  const int most = std::numeric_limits<int>::max();
  options.push_back(with_integer(
      {.group = kGroup,
       .name = "--exact-segments",
       .value = "N",
       .help = "Find the least horizon, in exact arithmetic, where no more segments than this "
               "make the horizon; it takes about 10 microseconds for each of them",
       .by_default = std::to_string(s.exact_segments)},
      0, most, [&s](int n) { s.exact_segments = n; }));
  options.push_back(with_integer(
      {.group = kGroup,
       .name = "--fragmented-segments",
       .value = "N",
       .help = "Run without collapse where no more segments than this make the horizon; it has "
               "about as many pieces in the end, of 72 bytes",
       .by_default = std::to_string(s.fragmented_segments)},
      0, most, [&s](int n) { s.fragmented_segments = n; }));
  options.push_back(with_integer({.group = kGroup,
                                  .name = "--worst-case",
                                  .value = "N",
                                  .help = "Measure terrains made to be the worst case as well, in "
                                          "sizes N/16 to N; 0 leaves them out",
                                  .by_default = std::to_string(s.worst_case)},
                                 0, kLargestWorstCase, [&s](int n) { s.worst_case = n; }));
  options.push_back(with_integer({.group = kGroup,
                                  .name = "--repeats",
                                  .value = "N",
                                  .help = "Runs to time for each row; the fastest counts",
                                  .by_default = std::to_string(s.repeats)},
                                 1, 1000, [&s](int n) { s.repeats = n; }));
  options.push_back({.group = kOutput,
                     .name = "--output",
                     .value = "PREFIX",
                     .help = "Write PREFIX.csv, PREFIX-series.csv, PREFIX.json and the plots, "
                             "PREFIX.svg",
                     .allowed = "a file name without extension",
                     .by_default = s.prefix,
                     .take = stored_name(s.prefix)});
  options.push_back({.group = kOutput,
                     .name = "--overwrite",
                     .help = "Replace these files where they exist",
                     .take = set_to(s.render.write.overwrite, true)});
}

} // namespace orograph
