// SPDX-License-Identifier: GPL-3.0-or-later
// Names for a surface's triangles and edges, and sets of its triangles.
#pragma once

#include "dem/grid.hpp"

#include <compare>
#include <cstdint>
#include <vector>

namespace orograph {

/// An edge of the triangulation, from the vertex of lower index to the higher. Points on it are
/// always reckoned in this direction, so that they are the same numbers everywhere, and the same
/// for a grid and the TIN of its triangles.
struct SurfaceEdge {
  std::uint32_t from, to; ///< vertex indices, from < to
  auto operator<=>(const SurfaceEdge&) const = default;
};

/// A set of triangles, a bit each.
class TriangleSet {
public:
  TriangleSet() = default;
  /// For triangles 0 to `count` - 1; none is in it.
  explicit TriangleSet(std::size_t count) : bits_((count + 63) / 64) {}

  bool empty() const { return bits_.empty(); }
  bool has(std::size_t triangle) const { return (bits_[triangle / 64] >> (triangle % 64)) & 1U; }
  void add(std::size_t triangle) { bits_[triangle / 64] |= std::uint64_t{1} << (triangle % 64); }
  /// Those from `first` to `end` - 1.
  void add_all(std::size_t first, std::size_t end) {
    while (first < end && first % 64 != 0) add(first++);
    for (; first + 64 <= end; first += 64) bits_[first / 64] = ~std::uint64_t{0};
    while (first < end) add(first++);
  }
  /// Of every second triangle from `first` on, up to `end` - 1, the first that isn't in it; `end`
  /// or more if all are.
  std::size_t first_missing_of_half(std::size_t first, std::size_t end) const {
    constexpr std::uint64_t kEverySecond = 0x5555'5555'5555'5555;
    while (first < end) {
      const std::uint64_t missing = (~bits_[first / 64] >> (first % 64)) & kEverySecond;
      const auto on = static_cast<std::size_t>(std::countr_zero(missing));
      if (missing != 0 && first % 64 + on < 64) return first + on;
      first = (first / 64 + 1) * 64 + first % 2;
    }
    return first;
  }

private:
  std::vector<std::uint64_t> bits_;
};

/// The two triangles of a cell: `lower` has the vertex to the south-west, `upper` the one to the
/// north-east of the diagonal. Along a row of cells the order lower 0, upper 0, lower 1, upper 1, …
/// goes from neighbour to neighbour.
enum class Half { lower = 0, upper = 1 };

/// A triangle's number, cell after cell, whether it is there or not.
inline std::size_t grid_triangle(const Grid& grid, int column, int row, Half half) {
  const auto cells = static_cast<std::size_t>(grid.columns) - 1;
  return 2 * (static_cast<std::size_t>(row) * cells + static_cast<std::size_t>(column)) +
         (half == Half::upper ? 1 : 0);
}
inline std::size_t grid_triangle_count(const Grid& grid) {
  return 2 * (static_cast<std::size_t>(grid.columns) - 1) *
         (static_cast<std::size_t>(grid.rows) - 1);
}

} // namespace orograph
