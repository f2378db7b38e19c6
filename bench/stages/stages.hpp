// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of drawing, each on its own.
#pragma once

#include "bench/stages/meter.hpp"
#include "bench/stages/staged_view.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace orograph {

/// Runs a stage once over all of a view, adds what it cost, and returns how many vertices it took.
/// What the stage needs, and what is to be reset, isn't measured.
using Stage = std::function<std::size_t(Meter&)>;

struct NamedStage {
  const char* name;
  Stage (*of)(const StagedView&); ///< the view must outlive the stage
};

/// In the order of the pipeline.
const std::vector<NamedStage>& all_stages();

/// What `clip` hands on: profiles with their visible runs by strip.
std::vector<ProfileInWork> clipped_profiles(const StagedView& view);
/// Joins the runs of profiles and lays them out as strokes. Reuses what memory they hold.
Layer laid_out(const StagedView& view, const StrokeSettings& settings,
               std::vector<ProfileInWork>& profiles);

} // namespace orograph
