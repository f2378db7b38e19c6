// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph render`: its options, and what a command line asks of it.
#include "cli/options/check_settings.hpp"
#include "cli/options/option_group.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/options.hpp"
#include "cli/options/parse_arguments.hpp"
#include "cli/options/settings_file.hpp"
#include "text/words.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

namespace orograph {
namespace {

// Of an option in force, given or by default.
bool has_meaning(std::string_view option, const RenderSettings& settings) {
  const ViewSpec& view = settings.map.view;
  const bool is_perspective = view.projection == Projection::perspective;
  const bool is_oblique = view.projection == Projection::oblique; // which --oblique says
  if (option == "projection" || option == "oblique") return is_oblique == (option == "oblique");
  const bool is_round = is_panorama(view.projection);
  if (option == "fov") // of a distance that is given alone, the field follows
    return is_perspective ? !view.distance_m || view.field_of_view : is_round && view.field_of_view;
  if (option == "distance") return is_perspective;
  if (option == "refraction" || option == "curvature-coefficient")
    return is_perspective || is_round;
  if (option == "elevation-above") return is_perspective && !view.has_eye();
  if (option == "strips") return is_round;
  if (option == "roll") return !is_round;
  if (option == "eye-height" || option == "eye-summit") return view.has_eye();
  if (option == "pitch") return view.look_azimuth.has_value();
  if (option == "dpi") return settings.write.format == Format::png;
  if (option == "device") return language_of(settings.write.format).has_value();
  if (option == "overlap") return settings.sheets.has_value();
  if (option == "pen-width") return settings.pens.empty() || settings.has_colours();
  if (option == "palette" || option == "colour") return !language_of(settings.write.format);
  if (option == "hidden") { // layers alone say it, too
    if (!settings.solids) return settings.dashes_hidden && !settings.hidden_layers.empty();
    return settings.dashes_hidden || settings.hidden_layers.empty();
  }
  if (option == "hidden-layers") return !settings.hidden_layers.empty();
  if (option == "label-size" || option == "label-halo")
    return !settings.labels.path.empty() || settings.map.labels.contours ||
           settings.map.labels.coordinates;
  if (option == "label-range" || option == "label-haze")
    return !settings.labels.path.empty() && view.has_eye();
  if (option == "label-rows" || option == "label-angle")
    return !settings.labels.path.empty() && is_round &&
           (option == "label-angle" || settings.map.labels.angle == Angle());
  if (option.starts_with("label-")) return !settings.labels.path.empty();
  if (option == "contour-ticks") return settings.map.style.asks_for("contours");
  if (option.starts_with("hachure-")) return settings.map.style.asks_for("hachures");
  if (option == "block-sides") return settings.map.style.asks_for("block");
  if (option.starts_with("light-") || option == "haze") return settings.map.style.light.has_value();
  return true;
}

std::vector<Conflict> drawing_conflicts() {
  std::vector<Conflict> conflicts = picture_conflicts();
  conflicts.push_back({"--clip-to", "--sheets", "sheets are cut at the edges of their paper"});
  conflicts.push_back({"--profiles", "--spacing", "give one of the two"});
  return conflicts;
}

constexpr std::string_view kDaily =
    "--bbox --bbox-lonlat --fill-voids --view-from --projection --fov --eye --eye-lonlat "
    "--eye-height --look-at --look-at-lonlat --look-azimuth --exaggeration --profiles "
    "--spacing --light --haze --flat --layers --palette --colour --hidden-layers --contours "
    "--mesh --drape --labels --scene --page --portrait --landscape --margin --pen-width "
    "--title --of --dpi --overwrite --report --device --pens --sheets --settings --help "
    "--help-all";

// What `settings` have in force of the command's options, those given and others by default.
void keep_options(RenderSettings& settings, const Command& tried, const GivenOptions& given) {
  settings.options =
      options_in_force(tried, given, std::filesystem::path(settings.report).parent_path());
  std::erase_if(settings.options,
                [&](const auto& entry) { return !has_meaning(entry.first, settings); });
}

} // namespace

void add_drawing_options(std::vector<Option>& options, RenderSettings& settings) {
  add_view_options(options, settings);
  add_panorama_options(options, settings);
  add_line_options(options, settings);
  add_ground_line_options(options, settings);
  add_scene_options(options, settings);
  add_page_options(options, settings);
  add_label_options(options, settings);
  add_lettering_options(options, settings);
  add_output_options(options, settings);
  add_pen_time_options(options, settings);
  add_plotting_options(options, settings);
}

std::vector<Conflict> picture_conflicts() {
  std::vector<Conflict> conflicts{
      {"--view-from", "--eye",
       "give --view-from to frame the terrain, or --eye to stand somewhere"},
      {"--view-from", "--eye-lonlat",
       "give --view-from to frame the terrain, or --eye-lonlat to stand somewhere"},
      {"--distance", "--eye", "the distance is from --eye to --look-at"},
      {"--distance", "--eye-lonlat", "the distance is from --eye-lonlat to --look-at-lonlat"},
      {"--eye", "--eye-lonlat", "give one of the two"},
      {"--look-at", "--look-at-lonlat", "give one of the two"},
      {"--look-at", "--look-azimuth", "look at a point, or in a direction"},
      {"--look-at-lonlat", "--look-azimuth", "look at a point, or in a direction"},
      {"--look-at", "--pitch", "the point tells how steeply to look"},
      {"--look-at-lonlat", "--pitch", "the point tells how steeply to look"},
      {"--azimuth-range", "--fov", "give one of the two"},
      {"--azimuth-range", "--look-azimuth", "the range is its own direction"},
      {"--azimuth-range", "--look-at", "the range is its own direction"},
      {"--azimuth-range", "--look-at-lonlat", "the range is its own direction"},
      {"--portrait", "--landscape", "give one of the two"},
      {"--detail", "--level-error", "cells are so large, or as large as the error lets them be"},
      {"--view-from", "--axonometric", "give one of the two"},
      {"--projection", "--axonometric", "leave --projection out"},
      {"--oblique", "--axonometric", "give one of the two"},
      {"--refraction", "--curvature-coefficient", "give one of the two"},
      {"--progress", "--no-progress", "give one of the two"},
      {"--quiet", "--progress", "give one of the two"}};
  for (const char* option :
       {"--view-from", "--projection", "--oblique", "--axonometric", "--distance", "--fov", "--eye",
        "--eye-lonlat", "--eye-height", "--eye-summit", "--look-at", "--look-at-lonlat",
        "--look-azimuth", "--pitch", "--roll", "--azimuth-range", "--altitude-range", "--strips"})
    conflicts.push_back({"--view", option, "the file holds the whole view"});
  for (const Conflict& conflict : terrain_conflicts()) conflicts.push_back(conflict);
  return conflicts;
}

Command render_command(RenderSettings& settings) {
  Command command{
      .name = "render",
      .summary = "Draw a perspective map of a terrain as vectors, hidden lines gone",
      .options = {},
      .conflicts = drawing_conflicts(),
      .examples = {
          {"orograph render dem.tif map.svg", "A map with the defaults, on A4."},
          {"orograph render N46E007.hgt N46E008.hgt map.svg", "Neighbouring tiles as one terrain."},
          {"orograph render dem.tif map.pdf --view-from 225/15 --page a2",
           "Seen from the south-west, low, on A2."},
          {"orograph render dem.tif map.png --eye 250800,4071000,900 --fov 60",
           "Seen from a point of the terrain's own coordinates."},
          {"orograph render dem.tif map.svg --layers contours,skyline --palette map",
           "Contours instead of profiles, in the colours of maps."},
          {"orograph render dem.tif map.svg --drape roads.gpkg --scene huts.toml",
           "With roads and huts on it."},
          {"orograph render dem.tif plot.hpgl --device hp7475a --margin 14", "For a plotter."},
          {"orograph render dem.tif lines.geojson", "The lines that are seen, for a GIS."}}};
  add_input(command.options, settings.inputs);
  OptionGroup(command.options)
      .name(
          "OUTPUT",
          fmt::format(
              "the drawing: a file whose extension names the format ({}), or - for standard output",
              joined(format_names(), ", ")),
          "", "", settings.output);
  add_terrain_options(command.options, settings.reading);
  add_drawing_options(command.options, settings);
  add_jobs(command.options, settings.jobs);
  add_skyline_options(command.options, settings);
  add_memory(command.options, settings.reading.max_memory);
  add_index_use(command.options, settings.reading.use_index);
  add_general_options(command.options, settings.settings_file, settings.quiet, settings.progress);
  add_full_help(command.options);
  command.daily = kDaily;
  return command;
}

std::optional<RenderSettings> parse_render(const std::vector<std::string>& arguments) {
  RenderSettings settings;
  const auto given = parse_arguments(render_command(settings), arguments);
  if (asks_for_help(given)) return std::nullopt;
  check_settings(settings, given);
  RenderSettings tried; // defaults are
  keep_options(settings, render_command(tried), given);
  return settings;
}

Command drawing_command(RenderSettings& settings) {
  Command command{.name = "render",
                  .summary = "Draw a perspective map of a terrain that is there",
                  .options = {},
                  .conflicts = drawing_conflicts(),
                  .examples = {}};
  add_drawing_options(command.options, settings);
  add_jobs(command.options, settings.jobs);
  add_general_options(command.options, settings.settings_file, settings.quiet, settings.progress);
  // A program has arguments and results of its own for these.
  for (const char* option : {"--report", "--quiet", "--progress", "--no-progress", "--help"})
    std::erase_if(command.options, [&](const Option& of) { return of.name == option; });
  return command;
}

void take_drawing(RenderSettings& settings, const NamedValues& options) {
  const auto given = take_named(drawing_command(settings), options);
  check_settings(settings, given);
  RenderSettings tried; // defaults are
  keep_options(settings, drawing_command(tried), given);
}

} // namespace orograph
