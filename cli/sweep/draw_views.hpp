// SPDX-License-Identifier: GPL-3.0-or-later
// Views from a queue to drawings and rows.
#pragma once

#include "cli/sweep/columns.hpp"
#include "cli/sweep/plan.hpp"
#include "cli/sweep/view_queue.hpp"
#include "dem/terrain.hpp"

#include <functional>
#include <optional>

#include "placing/placed_view.hpp"

namespace orograph {

/// What all views share.
struct SweepRun {
  const SweepSettings& settings;
  const TerrainData& terrain;
  const ViewList& views;
  const Columns& columns;
  const Plan& plan;
  const std::optional<TerrainFacts>& facts; ///< of the terrain as it was read, if views use it so
};

/// Draws a view: writes its drawing, and then its row. A view that can't be drawn has a row with
/// the reason. Throws Error where something can't be written.
void draw_view(const SweepRun& run, std::size_t view);

/// Draws views, `jobs` at a time, until the queue is empty; `done` is called after each, by one
/// thread at a time. The first Error that a view throws stops the queue and is thrown when the
/// others at work have ended. Memory: what the drawing of a view takes, `jobs` times.
void draw_views(const SweepRun& run, int jobs, ViewQueue& queue, const std::function<void()>& done);

} // namespace orograph
