// SPDX-License-Identifier: GPL-3.0-or-later
// What of sampled profiles shows in the page's columns, and how far apart they are there.
#pragma once

#include "geometry/box.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include "tone/sampled_profile.hpp"

namespace orograph {

enum class Sight : std::uint8_t {
  none,  ///< hidden, beside the frame, or no ground
  first, ///< nothing is in front of it, or a void, or something that stands far in front
  next   ///< ground that goes on from what is seen in front
};

/// Of one profile, a value a column.
struct SeenProfile {
  std::vector<Sight> sight;
  /// Across the line, what of the page shows ground between the profile and the one in front of it;
  /// 0 where nothing is seen, and behind a void.
  std::vector<float> gap_mm;
};

/// Of profiles front to back: what rises above all samples in front of it in its column is seen,
/// and with `both_sides` what falls below them as well.
/// Cost: some 10 ns a sample.
std::vector<SeenProfile> seen_profiles(std::span<const SampledProfile> profiles,
                                       const PageColumns& columns, const View& view,
                                       const Box2& frame_mm, bool both_sides = false);

} // namespace orograph
