// SPDX-License-Identifier: GPL-3.0-or-later
// Ranges of X that don't depend on each other.
#pragma once

#include "horizon/clip_profile.hpp"
#include "placing/placed_view.hpp"

#include <cstddef>
#include <vector>

namespace orograph {

/// A strip costs some 0.2 microseconds a slab, as much as forty vertices: 600 make that little.
constexpr double kVerticesAStrip = 600;

struct Strip {
  XRange range;       ///< what it shows
  XRange core;        ///< finite; where its horizon has blocks
  std::size_t blocks; ///< of its horizon
};

/// Strips that tile `range`, left to right, with about the same number of cut vertices in each. A
/// function of the placed view and the sector alone, never of how many cores there are.
/// `vertices_a_strip`: of a profile, on average. REQUIRES range.begin < range.end.
std::vector<Strip> plan_strips(const PlacedView& placed, const Sector& sector, XRange range,
                               double vertices_a_strip = kVerticesAStrip);

} // namespace orograph
