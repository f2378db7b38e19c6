// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/render.hpp"

#include "cli/finish_drawing.hpp"
#include "cli/progress.hpp"
#include "cli/report/name_report.hpp"
#include "cli/report/run_report.hpp"
#include "cli/report/skyline_table.hpp"
#include "cli/say.hpp"
#include "cli/tell_map.hpp"
#include "dem/read/read_terrain.hpp"
#include "geometry/error.hpp"
#include "map/describe_map.hpp"
#include "map/draw_level.hpp"
#include "map/look_around.hpp"
#include "map/name_places.hpp"
#include "placing/grounds.hpp"
#include "placing/level_of_detail.hpp"
#include "placing/observer.hpp"
#include "placing/placed_view.hpp"
#include "placing/read_overlays.hpp"
#include "placing/terrain_facts.hpp"
#include "placing/terrain_of_view.hpp"
#include "placing/terrains_for_maps.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace orograph {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void check_outputs(const RenderSettings& settings) {
  if (settings.output != "-")
    for (const std::string& name : output_names(settings)) check_writable(name, settings.write);
  for (const std::string& name : {settings.report, settings.skyline_table})
    if (!name.empty()) check_writable(name, settings.write);
}

// Of the file's own surface, as `visible` tells it, even where the picture has other cells; only of
// a raster that wasn't read as a whole that of the picture.
Skyline skyline_of(const TerrainOfView& terrain, const PlacedView& placed, const ViewSpec& view,
                   double step_deg) {
  const TerrainData& file = terrain.of_file();
  const bool is_level = &terrain.uncut() != &file;
  if (!is_level || file.larger_cells)
    return LookAround(*terrain, placed.border, observer_of(placed, terrain->map)).skyline(step_deg);
  const std::vector<BorderEdge> border = border_of(file.surface);
  return LookAround(file, border, observer_of(view, file)).skyline(step_deg);
}

void tell_check(const std::optional<CheckCounts>& check) {
  if (check)
    say("check: {} points asked, {} tied, {} drawn but hidden, {} visible but not "
        "drawn",
        check->asked, check->ties, check->hidden, check->missing);
}

void tell_check(const std::optional<CheckOfFile>& check) {
  if (check)
    say("check: {} points drawn asked of the file's surface, {} tied with it within {:.2g} mm, {} "
        "hidden by more",
        check->counts.asked, check->counts.ties, 2 * check->within_mm, check->counts.hidden);
}

} // namespace

void render(const RenderSettings& settings) {
  const auto start = Clock::now();
  check_outputs(settings);
  ProgressBar bar(shows_progress(settings.quiet, settings.progress));
  double read_share = 0; // of the bar, where reading takes long enough to be told
  const auto show_reading = [&](double fraction) {
    constexpr double kReadShare = 0.8;
    read_share = kReadShare;
    bar.show(kReadShare * fraction);
  };
  const TerrainForMap read =
      stands_on_nothing(settings)
          ? TerrainForMap{std::make_shared<const TerrainData>(read_ground(settings)), nullptr}
          : TerrainsForMaps(settings.inputs, settings.reading, settings.solids.get())
                .of(settings.map, show_reading);
  const TerrainData& whole = *read.terrain;
  if (!settings.quiet) {
    tell_doubts(whole);
    tell_eye_move(settings.map.view, whole);
  }
  const std::vector<Overlay> overlays = read_overlays(settings.overlays, whole);
  std::vector<Overlay> names;
  if (!settings.labels.path.empty()) names = read_overlays({&settings.labels, 1}, whole);
  const Overlay* const named = names.empty() ? nullptr : &names.front();
  const double read_s = seconds_since(start);

  const auto place_start = Clock::now();
  const MapSpec spec = with_room_for_names(settings.map, named);
  TerrainOfView terrain(whole, spec.view, read.facts);
  const std::optional<LevelOfDetail> level = choose_level(terrain, spec, settings.solids.get());
  PlacedView placed = placed_view(terrain, spec, settings.solids.get());
  placed.names = named;
  placed.overlays = overlays;
  const double place_s = seconds_since(place_start);
  if (!settings.quiet) tell_placing(placed, settings.map.view);

  Map map = draw_level(terrain, placed, spec, level, [&](double fraction) {
    bar.show(read_share + (1 - read_share) * fraction);
  });
  check_not_empty(map, spec.view, stands_on_nothing(settings));
  finish_drawing(map, settings);

  const auto write_start = Clock::now();
  const std::vector<Drawing> pages = sheets_and_overview(map.drawing, settings);
  const std::span<const Drawing> sheets =
      std::span(pages).first(pages.empty() ? 0 : pages.size() - 1);
  write_outputs(map.drawing, pages, settings);
  StageSeconds& seconds = map.facts.seconds;
  seconds.read = read_s;
  seconds.place = place_s;
  seconds.write = seconds_since(write_start);
  bar.finish(); // before anything is told: lines behind marks are read by nobody
  tell_check(map.facts.check);
  tell_check(map.facts.check_of_file);
  if (!settings.quiet)
    for (const std::string& line : map.facts.lettering) say_line(line);
  if (!settings.quiet && named) {
    tell_notes(names);
    if (map.facts.names) say_line(names_in_words(*map.facts.names));
  }
  if (!settings.quiet) {
    tell_overlays(overlays, map.facts.counts);
    tell_contours(settings.map.style, *terrain, map.drawing);
  }
  std::optional<Skyline> skyline;
  if (!settings.skyline_table.empty()) {
    skyline = skyline_of(terrain, placed, spec.view, settings.skyline_step_deg);
    write_skyline(*skyline, settings);
  }
  if (!settings.report.empty()) {
    seconds.total = seconds_since(start);
    describe_map(map, terrain, placed, spec);
    RunReport report = run_report(map, settings, sheets);
    report.skyline = skyline;
    write_report(report, settings.report, settings.write.overwrite);
  }
  if (skyline && !settings.quiet) tell_skyline(*skyline, settings);
  if (!settings.quiet)
    for (const std::string& line :
         closing_lines(map, sheets, placed, settings, seconds_since(start)))
      say_line(line);
}

} // namespace orograph
