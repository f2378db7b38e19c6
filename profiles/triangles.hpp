// SPDX-License-Identifier: GPL-3.0-or-later
// Names for a grid's triangles and edges.
#pragma once

#include "dem/grid.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

/// The two triangles of a cell: `lower` has the vertex to the south-west, `upper` the one to the
/// north-east of the diagonal. Along a row of cells the order lower 0, upper 0, lower 1, upper 1, …
/// goes from neighbour to neighbour.
enum class Half { lower = 0, upper = 1 };

/// An edge of the triangulation, from the vertex of lower index to the higher. Points on it are
/// always reckoned in this direction, so that they are the same numbers everywhere.
struct GridEdge {
  std::uint32_t from, to; ///< vertex indices, from < to
  bool operator==(const GridEdge&) const = default;
};

/// A set of triangles, a bit each.
class TriangleSet {
public:
  TriangleSet() = default;
  explicit TriangleSet(const Grid& grid)
      : cells_(static_cast<std::size_t>(grid.columns) - 1),
        bits_((2 * cells_ * (static_cast<std::size_t>(grid.rows) - 1) + 63) / 64) {}

  bool empty() const { return bits_.empty(); }
  bool has(int column, int row, Half half) const {
    const std::size_t at = position(column, row, half);
    return (bits_[at / 64] >> (at % 64)) & 1U;
  }
  void add(int column, int row, Half half) {
    const std::size_t at = position(column, row, half);
    bits_[at / 64] |= std::uint64_t{1} << (at % 64);
  }

private:
  std::size_t position(int column, int row, Half half) const {
    return 2 * (static_cast<std::size_t>(row) * cells_ + static_cast<std::size_t>(column)) +
           (half == Half::upper ? 1 : 0);
  }
  std::size_t cells_ = 0; ///< in a row
  std::vector<std::uint64_t> bits_;
};

} // namespace orograph
