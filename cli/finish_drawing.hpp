// SPDX-License-Identifier: GPL-3.0-or-later
// From a map as it is drawn to what a pen draws of it.
#pragma once

#include "cli/render_settings.hpp"
#include "map/map_facts.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Gives strokes to pens, cuts them, and brings them into the pen's order, as the settings want it.
/// Throws UsageError where no pen draws a layer.
void finish_drawing(Map& map, const RenderSettings& settings);

/// Of the files that the settings write: OUTPUT, or each sheet, "map-3.svg", and
/// "map-overview.svg".
std::vector<std::string> output_names(const RenderSettings& settings);

/// The sheets that the settings ask for, each in the pen's order, and behind them the overview;
/// none where one page is drawn.
std::vector<Drawing> sheets_and_overview(const Drawing& drawing, const RenderSettings& settings);

/// Writes the drawing, or all of `sheets` where there are any, or nothing where one can't be
/// written.
void write_outputs(const Drawing& drawing, const std::vector<Drawing>& sheets,
                   const RenderSettings& settings);

} // namespace orograph
