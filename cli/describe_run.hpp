// SPDX-License-Identifier: GPL-3.0-or-later
// What a run tells of itself: in the drawing's metadata and in the report.
#pragma once

#include "cli/draw_scene.hpp"
#include "cli/render_settings.hpp"
#include "cli/report.hpp"
#include "cli/scene.hpp"

namespace orograph {

/// Sets title and description: what makes the drawing again, nothing that varies from run to run.
void entitle(Drawing& drawing, const Terrain& terrain, const Scene& scene,
             const RenderSettings& settings);

/// Fills everything in the report but the seconds of reading, placing, writing and the total.
void describe_run(RunReport& report, const Terrain& terrain, const Scene& scene,
                  const DrawnScene& drawn, const RenderSettings& settings);

} // namespace orograph
