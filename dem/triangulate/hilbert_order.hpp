// SPDX-License-Identifier: GPL-3.0-or-later
// An order of places in which near ones are near.
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

} // namespace orograph
