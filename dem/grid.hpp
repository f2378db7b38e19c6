// SPDX-License-Identifier: GPL-3.0-or-later
// A grid of heights: the terrain of a DEM (docs/how-it-works.md).
#pragma once

#include "geometry/vec.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

namespace orograph {

/// Vertices in rows from the north, columns from the west, with heights in metres; NaN where there
/// is none. Each cell of four vertices is split by the diagonal from (column, row) to
/// (column + 1, row + 1) into an upper triangle (with the vertex to the north-east) and a lower one
/// (with the vertex to the south-west). A triangle with a NaN vertex isn't there.
///
/// Positions are metres east and north in the ground frame, whose origin is near the terrain, so
/// that they are small numbers.
struct Grid {
  int columns = 0, rows = 0;
  Vec2 first_vertex_m; ///< ground position of vertex (0, 0), the north-west one
  Vec2 column_step_m;  ///< from a column to the next, eastward
  Vec2 row_step_m;     ///< from a row to the next, southward
  /// Row-major, rows * columns. float unless the file has heights in double precision.
  std::variant<std::vector<float>, std::vector<double>> heights_m;

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  std::size_t size() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  }
  /// Ground position of a vertex in metres. Everything that needs it asks here, so that it is the
  /// same number everywhere.
  Vec2 position_m(int column, int row) const {
    return {first_vertex_m.x + column * column_step_m.x + row * row_step_m.x,
            first_vertex_m.y + column * column_step_m.y + row * row_step_m.y};
  }
  /// Height of one vertex; for loops over many, `std::visit` the heights once instead.
  double height_m(int column, int row) const {
    return std::visit([&](const auto& h) { return static_cast<double>(h[index(column, row)]); },
                      heights_m);
  }
};

/// The grid's smaller step in metres: the finest ground detail that it holds.
inline double cell_size_m(const Grid& grid) {
  return std::min(length(grid.column_step_m), length(grid.row_step_m));
}

} // namespace orograph
