// SPDX-License-Identifier: GPL-3.0-or-later
// How far a drawing's lines are from those of the same drawing with all its points.
#pragma once

#include "draw/drawing.hpp"

#include <cstdint>

namespace orograph {

struct SimplifiedDistance {
  /// Hausdorff distance between strokes, the largest; at least, since `whole` is rounded to the
  /// page's step as well: that much is taken off.
  double largest_mm = 0;
  std::uint64_t strokes = 0;   ///< compared
  std::uint64_t unmatched = 0; ///< of `simplified`, that `whole` doesn't have
};

/// REQUIRES that `simplified` and `whole` were drawn with the same settings but for `--simplify`.
/// Cost O(points).
SimplifiedDistance simplified_distance(const Drawing& simplified, const Drawing& whole);

} // namespace orograph
