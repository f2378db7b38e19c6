// SPDX-License-Identifier: GPL-3.0-or-later
// Rounding page points to the step that every format prints, and dropping what that makes empty or
// draws twice.
#pragma once

#include "draw/drawing.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace orograph {

/// The multiple of kPageStep_mm nearest to x_mm (ties to even), as the double nearest to that
/// decimal: printing it with 4 decimals, or in the fewest digits that read back, gives the exact
/// multiple. Never -0. Rounding twice changes nothing. REQUIRES |x_mm| < 4e11.
double rounded_to_page_step(double x_mm);

struct RoundingCounts {
  std::size_t points = 0;           ///< dropped because equal to the one before, or with a stroke
  std::size_t empty_strokes = 0;    ///< dropped: all points became one
  std::size_t repeated_strokes = 0; ///< dropped, as `repeated_strokes` has them
};

/// Rounds all page points of the layer, then drops points equal to the one before in their stroke,
/// on the page and, where the layer has map points, on the map as well; then strokes without length
/// on the page. Order stays, and points come to lie in it. Map points stay as they are. Points of
/// no stroke go as well. REQUIRES `map` empty or as long as `page_mm`. Cost O(points), in place
/// where points lie in the strokes' order.
RoundingCounts round_strokes(Layer& layer);

/// The numbers, rising, of the layer's strokes that have the points of an earlier one, in order or
/// reversed; where the layer has map points, of an earlier one of the same feature. REQUIRES that
/// strokes lie within its points and no coordinate is -0. Cost O(points) expected, on all cores,
/// with 24 to 40 bytes for each stroke.
std::vector<std::uint32_t> repeated_strokes(const Layer& layer);

/// Drops strokes that repeat an earlier one. REQUIRES a layer as `round_strokes` leaves it. In
/// place; costs what `repeated_strokes` does.
RoundingCounts drop_repeated_strokes(Layer& layer);

/// Both.
RoundingCounts round_to_page_step(Layer& layer);

} // namespace orograph
