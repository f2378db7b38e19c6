// SPDX-License-Identifier: GPL-3.0-or-later
// The pipeline between reading and writing: for each depth, front to back, cut, project, clip,
// draw.
#pragma once

#include "cli/instruments.hpp"
#include "cli/render_settings.hpp"
#include "cli/report.hpp"
#include "cli/scene.hpp"
#include "dem/terrain.hpp"
#include "draw/drawing.hpp"

#include <functional>
#include <optional>

namespace orograph {

struct DrawnScene {
  Drawing drawing;
  CountsReport counts;
  SecondsReport seconds; ///< facing, cut, project, clip and layout only
  LeftOutReport left_out;
  std::optional<CheckReport> check; ///< where the settings ask for it
};

/// Draws the layers that the settings ask for. `progress` is told the share done, after each
/// profile.
DrawnScene draw_scene(const Terrain& terrain, const Scene& scene, const RenderSettings& settings,
                      const std::function<void(double)>& progress,
                      const Instruments& instruments = {});

/// Throws Error if nothing is on the page.
void check_not_empty(const DrawnScene& drawn, const RenderSettings& settings);

} // namespace orograph
