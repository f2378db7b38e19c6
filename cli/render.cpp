// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/render.hpp"

#include "cli/describe_run.hpp"
#include "cli/draw_scene.hpp"
#include "cli/progress.hpp"
#include "cli/read_ground.hpp"
#include "cli/scene.hpp"
#include "cli/terrain_of_view.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

namespace orograph {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Runs a stage and tells how long it took.
template <class Stage>
auto timed(double& seconds, const Stage& stage) {
  const auto start = Clock::now();
  auto result = stage();
  seconds = seconds_since(start);
  return result;
}

void say(const RenderSettings& settings, const std::string& text) {
  if (!settings.quiet) fmt::print(stderr, "orograph: {}\n", text);
}

void check_outputs(const RenderSettings& settings) {
  if (settings.output != "-") check_writable(settings.output, settings.write);
  if (!settings.report.empty()) check_writable(settings.report, settings.write);
}

} // namespace

void render(const RenderSettings& settings) {
  const auto start = Clock::now();
  check_outputs(settings);
  RunReport report;
  SecondsReport& seconds = report.seconds;

  const Terrain whole = timed(seconds.read, [&] { return read_ground(settings); });
  const auto place_start = Clock::now();
  const TerrainOfView of_view(whole, settings);
  const Terrain& terrain = *of_view;
  const Scene scene = place_scene(terrain, settings, &of_view.uncut());
  seconds.place = seconds_since(place_start);
  if (scene.exaggeration_chosen && scene.exaggeration != 1)
    say(settings, fmt::format("heights are exaggerated {} times (--exaggeration 1 draws them true)",
                              scene.exaggeration));

  ProgressBar bar(shows_progress(settings.quiet, settings.progress));
  DrawnScene drawn =
      draw_scene(terrain, scene, settings, [&](double fraction) { bar.show(fraction); });
  check_not_empty(drawn, settings);
  if (const auto& check = drawn.check)
    fmt::print(stderr,
               "orograph: check: {} points asked, {} tied, {} drawn but hidden, {} visible but not "
               "drawn\n",
               check->asked, check->ties, check->hidden, check->missing);
  entitle(drawn.drawing, terrain, scene, settings);
  const auto write_start = Clock::now();
  write_drawing(drawn.drawing, settings.output, settings.write);
  seconds.write = seconds_since(write_start);
  bar.finish();

  if (settings.report.empty()) return;
  seconds.total = seconds_since(start);
  describe_run(report, terrain, scene, drawn, settings);
  write_report(report, settings.report, settings.write.overwrite);
}

} // namespace orograph
