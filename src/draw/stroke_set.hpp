// SPDX-License-Identifier: GPL-3.0-or-later
// A hash set of a layer's strokes, by their points in either direction.
#pragma once

#include "draw/drawing.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace orograph {

/// Holds stroke numbers and looks at the layer for their points: while the set is used, the layer
/// must stay as it is. REQUIRES that strokes lie within its points and no coordinate is -0.
class StrokeSet {
public:
  /// Room for all strokes of the layer, in 16 to 24 bytes each. Looks at all points, on all cores.
  explicit StrokeSet(const Layer& layer);
  /// Whether the stroke was new: no inserted one has the same points, in order or reversed.
  /// Cost O(1), or O(points of the stroke) if it isn't new, expected.
  bool insert(std::uint32_t stroke_number);

private:
  const Layer& layer_;
  std::vector<std::uint64_t> hashes_;
  std::vector<std::uint32_t> slots_; ///< number + 1, 0 where free; a power of two of them
};

} // namespace orograph
