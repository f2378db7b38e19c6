// SPDX-License-Identifier: GPL-3.0-or-later
// Points that are given more than once.
#pragma once

#include "geometry/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// For each point the number of the first one that is equal to it in all coordinates: its own
/// unless an earlier one is. 0 and -0 are equal. REQUIRES finite coordinates. Cost O(n).
std::vector<std::uint32_t> first_equal(std::span<const Vec3> points);

} // namespace orograph
