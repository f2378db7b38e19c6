// SPDX-License-Identifier: GPL-3.0-or-later
// How dark light leaves the ground.
#pragma once

#include <vector>

#include "tone/plan_on_page.hpp"
#include "tone/tone_request.hpp"

namespace orograph {

/// The share of black that each sample's surroundings should have on paper, haze taken off; row by
/// row, NaN where nothing is seen. Empty without light.
std::vector<float> darkness_of(const PlanOnPage& plan, const PageColumns& columns, const View& view,
                               const ToneRequest& request);

} // namespace orograph
