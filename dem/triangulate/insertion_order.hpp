// SPDX-License-Identifier: GPL-3.0-or-later
// In which order a triangulation takes its places.
#pragma once

#include "geometry/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// The places' numbers: three that make a triangle first, then rounds that grow, so that inserting
/// takes O(n log n) steps or so wherever the places are. Near ones are near in a round if they are
/// in the list. Empty where all are on one line. REQUIRES places that are all different.
std::vector<std::uint32_t> insertion_order(std::span<const Vec2> places);

} // namespace orograph
