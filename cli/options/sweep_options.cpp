// SPDX-License-Identifier: GPL-3.0-or-later
// What `orograph sweep` varies, and how it goes about it: render's options, some of them with
// lists.
#include "cli/options/check_settings.hpp"
#include "cli/options/option.hpp"
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/options.hpp"
#include "cli/options/parse_arguments.hpp"
#include "geometry/error.hpp"
#include "map/check_spec.hpp"
#include "placing/fingerprint.hpp"
#include "text/number_list.hpp"
#include "text/quantities.hpp"
#include "text/text_of_file.hpp"
#include "text/words.hpp"
#include "write/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>

namespace orograph {
namespace {

constexpr auto kVaried = "What varies", kWork = "Work";
constexpr auto kList = "numbers with commas between, ranges FROM:TO:STEP, or both";

// How the option of a single value takes one of a list's.
struct ListOption {
  Parameter parameter;
  std::string_view single; ///< render's option
  std::string_view before, after;
  std::string_view help;
};

constexpr std::array<ListOption, 8> kListOptions{
    {{Parameter::azimuth, "--view-from", "", "/25",
      "Where the viewer stands, seen from the terrain, clockwise from north"},
     {Parameter::elevation, "--view-from", "180/", "",
      "Where the viewer stands, above the horizontal"},
     {Parameter::look_azimuth, "--look-azimuth", "", "",
      "With an eye, where it looks, clockwise from true north"},
     {Parameter::pitch, "--pitch", "", "", "With --look-azimuth, look up by this"},
     {Parameter::distance, "--distance", "", "", "From the eye to the point looked at"},
     {Parameter::fov, "--fov", "", "", "Horizontal field of view; perspective only"},
     {Parameter::exaggeration, "--exaggeration", "", "", "Multiply all heights"},
     {Parameter::profiles, "--profiles", "", "", "Number of profiles"}}};

Option taken(std::vector<Option>& options, std::string_view name) {
  const auto found = std::find_if(options.begin(), options.end(),
                                  [&](const Option& option) { return option.name == name; });
  Option option = *found;
  options.erase(found);
  return option;
}

// A turn's end is its beginning, where nothing else goes on along it.
void drop_full_turn(std::vector<double>& azimuths) {
  if (azimuths.size() > 1 && std::abs(azimuths.back() - azimuths.front()) == 360)
    azimuths.pop_back();
}

void add_axis(std::vector<Axis>& axes, Axis axis) {
  const auto after = std::find_if(axes.begin(), axes.end(), [&](const Axis& other) {
    return other.parameter > axis.parameter;
  });
  axes.insert(after, std::move(axis));
}

void add_listed(OptionGroup& group, const ListOption& list, const Option& single,
                SweepSettings& s) {
  const std::string name = names_of(list.parameter).option;
  std::string allowed = single.allowed;
  if (list.parameter == Parameter::azimuth) allowed = "degrees";
  if (list.parameter == Parameter::elevation)
    allowed = "degrees, 0 to 90, or from -90 with --underside draw";
  std::string by_default = single.by_default;
  if (list.parameter == Parameter::azimuth) by_default = "180";
  if (list.parameter == Parameter::elevation) by_default = "25";
  group.value(
      name + " LIST", list.help, fmt::format("{}; {}", kList, allowed), by_default,
      [name, list, allowed, single, &s](const std::string& text) {
        if (list.parameter == Parameter::exaggeration && text == "auto") return single.take(text);
        const bool by_name = list.parameter == Parameter::azimuth; // N, NNE, …
        Axis axis{list.parameter,
                  parse_number_list(name, text, by_name ? parse_azimuth_deg : parse_number)};
        for (const double value : axis.values)
          if (!single.take(fmt::format("{}{}{}", list.before, number_text(value), list.after)))
            throw UsageError(
                fmt::format("{} '{}' can't be used: {}", name, text, number_text(value)),
                fmt::format("its values are {}", allowed));
        add_axis(s.axes, std::move(axis));
        return true;
      });
}

std::optional<Shard> parse_shard(const std::string& text) {
  const std::vector<std::string> parts = split(text, '/');
  if (parts.size() != 2) return std::nullopt;
  const auto index = parse_integer(parts[0]), count = parse_integer(parts[1]);
  if (!index || !count || *index < 1 || *index > *count) return std::nullopt;
  return Shard{*index, *count};
}

void add_varied_options(std::vector<Option>& options, SweepSettings& s) {
  OptionGroup group(options, kVaried);
  // Azimuth and elevation are of one option; it goes after both.
  for (const ListOption& list : kListOptions) {
    Option single = taken(options, list.single);
    if (list.parameter == Parameter::azimuth) options.push_back(single);
    add_listed(group, list, single, s);
  }
  group.name("--eye-path FILE",
             "Stand along the line that a vector file holds: at its vertices, looking where it "
             "leads unless told otherwise; with Z at these heights, else on the ground",
             "a file with one line that GDAL opens", "", s.eye_path);
  group.number("--eye-step M", "Stand every so far along --eye-path instead",
               {.unit = "metres", .low = 0, .low_excluded = true}, s.eye_step_m);
  group.name("--views FILE",
             "Every view of a list: TOML with a table [[view]] for each, with the keys of a view "
             "file (docs/pipeline.md) and, if wanted, a name",
             "a TOML file", "", s.views_file);
  group.flag("--zip", "Take the lists together, first with first, instead of crossing them",
             s.zipped);
  group.name("--name TEMPLATE", "What drawings are called: text with {index}, {azimuth}, … in it",
             "a name without slashes", "all that varies, as in azimuth-045_elevation-05",
             s.name_template);
}

void add_work_options(std::vector<Option>& options, SweepSettings& s) {
  OptionGroup group(options, kWork);
  group.flag("--overwrite", "Remove an older sweep in OUT_DIR first", s.render.write.overwrite);
  group.flag("--resume", "Go on with the sweep in OUT_DIR: draw what isn't drawn yet", s.resume);
  constexpr int kMostJobs = 200; // files that are written at a time
  group.whole("-j, --jobs N", "Views to draw at a time", 1, kMostJobs, s.jobs,
              "one for each core; under mpirun one");
  group.parsed("--shard I/N",
               "Draw the Ith of N parts of the views, and no tables: orograph merge makes them "
               "when all parts are drawn",
               "whole numbers, I from 1 to N", "", parse_shard, s.shard);
  group.flag("--no-seconds",
             "Leave the column out that differs from run to run, so that all files are the same",
             s.seconds, false);
  group.flag("--yes", fmt::format("Draw more than {:.0f} views", kManyViews), s.many);
}

std::vector<Conflict> sweep_conflicts() {
  std::vector<Conflict> conflicts{
      {"--profiles", "--spacing", "give one of the two"},
      {"--overwrite", "--resume", "give one of the two"},
      {"--overwrite", "--shard", "shards don't remove each other's drawings: empty OUT_DIR first"},
      {"--eye-path", "--eye", "give one of the two"},
      {"--eye-path", "--eye-lonlat", "give one of the two"},
      {"--eye-path", "--azimuth", "frame the terrain, or stand on the path"},
      {"--eye-path", "--elevation", "frame the terrain, or stand on the path"},
      {"--eye-path", "--distance", "the distance is from the path to what is looked at"},
      {"--eye-path", "--views", "the file holds whole views"}};
  for (const Conflict& conflict : picture_conflicts()) {
    if (conflict.one == "--view-from") {
      conflicts.push_back({"--azimuth", conflict.other, conflict.right});
      conflicts.push_back({"--elevation", conflict.other, conflict.right});
    } else if (conflict.one == "--view" && conflict.other == "--view-from") {
      conflicts.push_back({"--views", "--azimuth", "the file holds whole views"});
      conflicts.push_back({"--views", "--elevation", "the file holds whole views"});
    } else {
      conflicts.push_back(
          {conflict.one == "--view" ? "--views" : conflict.one, conflict.other, conflict.right});
    }
  }
  return conflicts;
}

// A small text by its name and by what it says.
std::vector<std::string> what_it_says(const std::string& path) {
  const std::string text = text_of_file(path, {.most_bytes = 1'000'000, .noun = "a text"});
  return {std::filesystem::path(path).filename().string(), fingerprint(std::string_view(text))};
}

// Where the files are, and how the work is done, decides nothing of what is drawn.
std::map<std::string, std::vector<std::string>> deciding(const GivenOptions& given,
                                                         const RenderSettings& render) {
  std::map<std::string, std::vector<std::string>> values;
  for (const auto& [name, option] : given) values[name] = option.values;
  for (const char* option : {"INPUT", "OUT_DIR", "--overwrite", "--resume", "--jobs", "--shard",
                             "--yes", "--quiet", "--progress", "--no-progress", "--settings",
                             "--eye-path", "--views", "--breaklines", "--boundary", "--scene"})
    values.erase(option);
  if (values.contains("--template")) values["--template"] = what_it_says(render.template_file);
  if (values.contains("--pens")) values["--pens"] = what_it_says(render.pens_file);
  if (values.contains("--device") && is_device_file(render.device))
    values["--device"] = what_it_says(render.device);
  return values;
}

void check_sweep(SweepSettings& settings, const GivenOptions& given) {
  RenderSettings& render = settings.render;
  if (!settings.zipped)
    for (Axis& axis : settings.axes)
      if (axis.parameter == Parameter::azimuth || axis.parameter == Parameter::look_azimuth)
        drop_full_turn(axis.values);
  check_dpi(render, given);
  if (settings.eye_path.empty())
    refuse(given, "--eye-step", "without a path", "give --eye-path FILE too");
  if (!settings.eye_path.empty() && render.map.view.projection != Projection::perspective &&
      !is_panorama(render.map.view.projection))
    throw UsageError("--eye-path has no meaning in a parallel view",
                     "give --azimuth and --elevation, or use --projection perspective");
  const ViewSpec given_view = render.map.view;
  if (!settings.eye_path.empty()) {
    render.map.view.eye_map = GivenPlace(0, 0); // somewhere on it
    if (!given_view.look_azimuth && given.contains("--pitch"))
      render.map.view.look_azimuth = Angle();
  }
  check_picture_settings(render, given);
  for (const Axis& axis : settings.axes)
    if (axis.parameter == Parameter::elevation) {
      MapSpec lowest = render.map;
      lowest.view.from_elevation = Angle::degrees(std::ranges::min(axis.values));
      check_underside(lowest);
    }
  check_plotting(render, given);
  if (!settings.views_file.empty()) render.map.view.eye_map = GivenPlace(0, 0); // perhaps
  check_lettering(render, given);
  check_labels(render, given);
  render.map.view = given_view;
  if (settings.views_file.empty()) return;
  settings.views = read_view_list(settings.views_file);
  for (const NamedView& view : settings.views)
    if (render.map.view.curvature == Curvature::on && view.view.cuts())
      throw UsageError("--curvature on bends the terrain away from a view's front and back plane",
                       "leave it out, or leave the planes out of " + settings.views_file);
}

} // namespace

Command sweep_command(SweepSettings& settings) {
  RenderSettings& render = settings.render;
  Command command{
      .name = "sweep",
      .summary = "Draw many views of a terrain, with tables and a page to look through them",
      .options = {},
      .conflicts = sweep_conflicts(),
      .examples = {
          {"orograph sweep dem.tif out --azimuth 0:360:5",
           "Seen from all around: 72 drawings, tables, and out/index.html."},
          {"orograph sweep dem.tif out --azimuth 0:360:15 --elevation 5:60:5 --of pdf -j 4",
           "Every azimuth at every elevation, four at a time."},
          {"orograph sweep dem.tif out --eye-path trail.gpkg --eye-step 250",
           "What is seen on the way, every 250 m."}}};
  std::vector<Option>& options = command.options;
  add_input(options, render.inputs);
  OptionGroup(options).name("OUT_DIR",
                            "the folder for drawings, sweep.csv, sweep.json and index.html; it is "
                            "made where it isn't there",
                            "", "", settings.out_dir);
  add_terrain_options(options, render.reading);
  std::vector<Option> picture;
  add_drawing_options(picture, render);
  // A view is a file, and no time is told of a pen's.
  for (const char* option : {"--view", "--report", "--overwrite", "--sheets", "--overlap",
                             "--pen-speed", "--pen-up-speed", "--pen-lift-s"})
    taken(picture, option);
  for (Option& option : picture)
    if (option.name == "--of") {
      option.help = "Format of the drawings";
      option.by_default = "svg";
    }
  std::vector<Option> varied = picture;
  add_varied_options(varied, settings);
  std::erase_if(varied, [](const Option& o) { return o.name == "--view-from"; });
  // First what makes it a sweep.
  std::stable_partition(varied.begin(), varied.end(),
                        [](const Option& o) { return o.group == kVaried; });
  options.insert(options.end(), varied.begin(), varied.end());
  add_work_options(options, settings);
  add_memory(options, render.reading.max_memory);
  add_general_options(options, render.settings_file, render.quiet, render.progress);
  return command;
}

Command merge_command(MergeSettings& settings) {
  Command command{.name = "merge",
                  .summary = "Make the tables and the page of a sweep that was drawn in shards",
                  .options = {},
                  .conflicts = {},
                  .examples = {{"orograph merge out", "After all shards of a sweep into out."},
                               {"orograph merge out part1 part2",
                                "Of shards in folders of their own, brought together in out."}}};
  OptionGroup(command.options)
      .value("OUT_DIR",
             "the sweep's folder, and after it those of shards that were drawn "
             "elsewhere, to be copied into it",
             "", "",
             [&settings](const std::string& text) {
               if (settings.out_dir.empty())
                 settings.out_dir = text;
               else
                 settings.shard_dirs.push_back(text);
               return !text.empty();
             })
      .repeatable();
  add_quiet(command.options, settings.quiet);
  add_help(command.options);
  return command;
}

std::optional<SweepSettings> parse_sweep(const std::vector<std::string>& arguments) {
  SweepSettings settings;
  const auto given = parse_arguments(sweep_command(settings), arguments);
  if (asks_for_help(given)) return std::nullopt;
  check_sweep(settings, given);
  settings.options = deciding(given, settings.render);
  return settings;
}

std::optional<MergeSettings> parse_merge(const std::vector<std::string>& arguments) {
  MergeSettings settings;
  const auto given = parse_arguments(merge_command(settings), arguments);
  if (asks_for_help(given)) return std::nullopt;
  return settings;
}

} // namespace orograph
