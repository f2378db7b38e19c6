// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph accuracy` and `orograph fragmentation`: their options, and what a command line asks of
// them.
#include "cli/options/check_settings.hpp"
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/options.hpp"
#include "cli/options/parse_arguments.hpp"
#include "geometry/error.hpp"
#include "text/quantities.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <limits>

namespace orograph {
namespace {

constexpr auto kMeasures = "Measures";
constexpr int kMostProfiles = 100000, kLargestWorstCase = 10000;

// "60,150,rows"
std::optional<std::vector<std::optional<int>>> parse_counts(const std::string& text) {
  std::vector<std::optional<int>> counts;
  for (const std::string& part : split(text, ',')) {
    if (part == "rows") {
      counts.emplace_back();
      continue;
    }
    const auto count = parse_integer(part);
    if (!count || *count < 1 || *count > kMostProfiles) return std::nullopt;
    counts.emplace_back(count);
  }
  return counts;
}

void add_repeats(OptionGroup& group, int& repeats) {
  group.whole("--repeats N", "Runs to time for each row; the fastest counts", 1, 1000, repeats);
}

void add_files(std::vector<Option>& options, const char* which, std::string& prefix,
               RenderSettings& render) {
  OptionGroup(options, kOutput)
      .name("--output PREFIX", which, "a file name without extension", "no files", prefix)
      .flag("--overwrite", "Replace these files where they exist", render.write.overwrite);
}

void add_accuracy_options(std::vector<Option>& options, AccuracySettings& s) {
  OptionGroup group(options, kMeasures);
  group.parsed(
      "--profiles LIST", "Numbers of profiles to compare; all else is varied at the middle one",
      fmt::format(
          "whole numbers, 1 to {}, or rows for one to each row of the grid, with commas between",
          kMostProfiles),
      "60,150,300,rows", parse_counts, s.profiles);
  group.whole("--probes N",
              "Random points of each row's profiles to ask of the ray walk, and as many to each mm "
              "of its other lines",
              100, 100000000, s.probes);
  add_repeats(group, s.repeats);
  add_files(options, "Write PREFIX.csv, PREFIX.json and the curve, PREFIX.svg", s.prefix, s.render);
}

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

template <class Number>
std::string listed(const std::vector<Number>& numbers) {
  std::vector<std::string> words;
  for (const Number number : numbers) words.push_back(fmt::format("{}", number));
  return joined(words, ",");
}

void add_fragmentation_options(std::vector<Option>& options, FragmentationSettings& s) {
  OptionGroup group(options, kMeasures);
  group.parsed(
      "--profiles LIST", "Numbers of profiles",
      fmt::format("whole numbers, 1 to {}, with commas between", kMostProfiles), listed(s.profiles),
      list_of<int>(parse_integer, [](int n) { return n >= 1 && n <= kMostProfiles; }), s.profiles);
  group.parsed("--elevations LIST", "Where the viewer stands above the horizontal",
               "degrees, 0 to 90, with commas between", listed(s.elevations_deg),
               list_of<double>(parse_number, [](double deg) { return deg >= 0 && deg <= 90; }),
               s.elevations_deg);
  group.parsed("--azimuths LIST",
               "Where the viewer stands, clockwise from north; profiles run across: along the rows "
               "of a grid from 180, along its columns from 90",
               "degrees, -360 to 360, with commas between", listed(s.azimuths_deg),
               list_of<double>(parse_number, [](double deg) { return deg >= -360 && deg <= 360; }),
               s.azimuths_deg);
  const int most = std::numeric_limits<int>::max();
  group.whole("--exact-segments N",
              "Find the least horizon, in exact arithmetic, where no more segments than this make "
              "the horizon; it takes about 10 microseconds for each of them",
              0, most, s.exact_segments);
  group.whole("--fragmented-segments N",
              "Run without collapse where no more segments than this make the horizon; it has "
              "about as many pieces in the end, of 72 bytes",
              0, most, s.fragmented_segments);
  group.whole(
      "--worst-case N",
      "Measure terrains made to be the worst case as well, in sizes N/16 to N; 0 leaves them out",
      0, kLargestWorstCase, s.worst_case);
  add_repeats(group, s.repeats);
  add_files(options, "Write PREFIX.csv, PREFIX-series.csv, PREFIX.json and the plots, PREFIX.svg",
            s.prefix, s.render);
}

} // namespace

Command accuracy_command(AccuracySettings& settings) {
  RenderSettings& render = settings.render;
  Command command{.name = "accuracy",
                  .summary = "Measure what each setting costs in time, and in error on paper",
                  .options = {},
                  .conflicts = picture_conflicts(),
                  .examples = {{"orograph accuracy dem.tif --output accuracy",
                                "The table, and accuracy.csv, .json and .svg (the curve)."},
                               {"orograph accuracy dem.tif --view-from 225/10 --profiles 100,200",
                                "Seen from the south-west, low, with two numbers of profiles."}}};
  add_input(command.options, render.inputs);
  add_terrain_options(command.options, render.reading);
  // Overviews are among the settings that are measured.
  std::erase_if(command.options, [](const Option& o) { return o.name == "--overview"; });
  add_view_options(command.options, render);
  add_page_options(command.options, render);
  add_accuracy_options(command.options, settings);
  add_jobs(command.options, render.jobs);
  add_memory(command.options, render.reading.max_memory);
  add_general_options(command.options, render.settings_file, render.quiet, render.progress);
  return command;
}

std::optional<AccuracySettings> parse_accuracy(const std::vector<std::string>& arguments) {
  AccuracySettings settings;
  const auto given = parse_arguments(accuracy_command(settings), arguments);
  if (asks_for_help(given)) return std::nullopt;
  refuse_scenes(settings.render.inputs);
  check_picture_settings(settings.render, given);
  if (is_panorama(settings.render.map.view.projection))
    throw UsageError("accuracy measures plane pictures, and a panorama is none",
                     "use --projection perspective; orograph render --check asks panoramas");
  check_prefix(settings.render, settings.prefix, {".csv", ".json", ".svg"});
  return settings;
}

Command fragmentation_command(FragmentationSettings& settings) {
  RenderSettings& render = settings.render;
  Command command{
      .name = "fragmentation",
      .summary = "Measure how the horizon fragments, and what collapse keeps of it",
      .options = {},
      .conflicts = terrain_conflicts(),
      .examples = {{"orograph fragmentation dem.tif --output fragmentation",
                    "The tables, and fragmentation.csv, -series.csv, .json and .svg (the plots)."},
                   {"orograph fragmentation dem.tif --profiles 60 --elevations 25 --azimuths 180",
                    "The paper's number of profiles, in one view."}}};
  command.conflicts.push_back({"--progress", "--no-progress", "give one of the two"});
  command.conflicts.push_back({"--quiet", "--progress", "give one of the two"});
  add_input(command.options, render.inputs);
  add_terrain_options(command.options, render.reading);
  add_fragmentation_options(command.options, settings);
  add_jobs(command.options, render.jobs);
  add_memory(command.options, render.reading.max_memory);
  add_general_options(command.options, render.settings_file, render.quiet, render.progress);
  return command;
}

std::optional<FragmentationSettings>
parse_fragmentation(const std::vector<std::string>& arguments) {
  FragmentationSettings settings;
  const auto given = parse_arguments(fragmentation_command(settings), arguments);
  if (asks_for_help(given)) return std::nullopt;
  refuse_scenes(settings.render.inputs);
  check_prefix(settings.render, settings.prefix, {".csv", "-series.csv", ".json", ".svg"});
  return settings;
}

} // namespace orograph
