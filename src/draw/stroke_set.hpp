// SPDX-License-Identifier: GPL-3.0-or-later
// A hash set of a layer's strokes, by their points in either direction.
#pragma once

#include "draw/drawing.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace orograph {

/// Holds stroke numbers only and looks at the layer for their points: while the set is used, the
/// points of inserted strokes must stay. Coordinates must not be -0.
class StrokeSet {
public:
  /// Room for `capacity` strokes, in 8 to 16 bytes each.
  StrokeSet(const Layer& layer, std::size_t capacity);
  /// Whether the stroke was new: no inserted one has the same points, in order or reversed.
  /// Cost O(points of the stroke) expected.
  bool insert(std::uint32_t stroke_number);

private:
  const Layer& layer_;
  std::vector<std::uint32_t> slots_; ///< number + 1, 0 where free; a power of two of them
};

} // namespace orograph
