// SPDX-License-Identifier: GPL-3.0-or-later
// Where profiles are cut so that lines can be even on the page, whatever the ground's slope.
#pragma once

#include <span>
#include <vector>

#include "tone/sampled_profile.hpp"
#include "tone/seen_profiles.hpp"
#include "tone/tone_request.hpp"

namespace orograph {

struct PlanOnPage {
  std::vector<SampledProfile> profiles; ///< front to back
  std::vector<SeenProfile> seen;
};

/// Profiles at the planned depths, and between them where lines would be farther apart than
/// sqrt(2) times the spacing along 2 mm of a line or more: steps between two profiles are halved,
/// at most six times. In a view from within the terrain ground in front of the first depth is
/// looked at from `nearest_m` on, unless it is under the eye. Of the planned profiles number i has
/// as its level the number of times that i + 1 can be halved.
PlanOnPage plan_on_page(const ProfileSampler& sampler, std::span<const double> depths_m,
                        double nearest_m, const PageColumns& columns, const View& view,
                        const Box2& frame_mm, const ToneRequest& request);

/// The same without any added profiles.
PlanOnPage as_planned(const ProfileSampler& sampler, std::span<const double> depths_m,
                      const PageColumns& columns, const View& view, const Box2& frame_mm,
                      bool both_sides);

} // namespace orograph
