// SPDX-License-Identifier: GPL-3.0-or-later
// Orders in which places are taken.
#pragma once

#include "geometry/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// The places' numbers along a Hilbert curve over their box (Hilbert 1891). Equal places stand
/// together, by number; the order of different places depends on where they are only, however near
/// they are to each other. REQUIRES coordinates within 1e300. Cost O(n log n).
std::vector<std::uint32_t> hilbert_order(std::span<const Vec2> places);

/// The places' numbers: three that make a triangle first, then rounds that grow, so that inserting
/// takes O(n log n) steps or so wherever the places are. Near ones are near in a round if they are
/// in the list. Empty where all are on one line. REQUIRES places that are all different.
std::vector<std::uint32_t> insertion_order(std::span<const Vec2> places);

} // namespace orograph
