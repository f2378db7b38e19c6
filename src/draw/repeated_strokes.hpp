// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes that are drawn twice.
#pragma once

#include "draw/drawing.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

/// The numbers, rising, of the layer's strokes that have the points of an earlier one, in order or
/// reversed. REQUIRES that strokes lie within its points and no coordinate is -0. Cost O(points)
/// expected, on all cores, with 24 to 40 bytes for each stroke.
std::vector<std::uint32_t> repeated_strokes(const Layer& layer);

} // namespace orograph
