// SPDX-License-Identifier: GPL-3.0-or-later
// The quick cut of a grid by planes: line after line of its vertices, many at a time.
#pragma once

#include "dem/grid.hpp"
#include "profiles/profile.hpp"
#include "profiles/triangles.hpp"
#include "profiles/walk_grid.hpp"
#include "view/view.hpp"

#include <vector>

namespace orograph {

/// u and v of a grid's vertices, as a number of the column and one of the row.
struct LinePlaces {
  static constexpr int kBeside = 2; ///< columns and rows that are there on each side of the grid
  std::vector<double> column_u, column_v, row_u, row_v;
  double u(int column, int row) const {
    return column_u[static_cast<std::size_t>(column + kBeside)] +
           row_u[static_cast<std::size_t>(row + kBeside)];
  }
  double v(int column, int row) const {
    return column_v[static_cast<std::size_t>(column + kBeside)] +
           row_v[static_cast<std::size_t>(row + kBeside)];
  }
};

/// Of the three families of edges (along columns, rows and diagonals) the one whose depth changes
/// most has all of its lines crossed by the plane, one after another, and between two of them there
/// is just one more crossing, of an edge of one of the other families. So the profile's vertices
/// are found by plain arithmetic on arrays.
class LineCutter {
public:
  /// Whether rows run along the ground frame's x and columns along its y. There u and v of a vertex
  /// are a number of its column and one of its row, added, to the bit.
  static bool can_cut(const Grid& grid);

  /// REQUIRES `can_cut(grid)`, and that the grid and `level` outlive the cutter. Unless depth rises
  /// or falls along all rows, columns and diagonals in floating point as well, planes that are
  /// within `rounding_m` of a vertex aren't cut.
  LineCutter(const Grid& grid, const View& view, const TriangleSet& level, double rounding_m);

  /// Adds the profile in the plane to `out`, bit for bit that of `walk_grid`, but for what lies
  /// farther than a few vertices outside `range`. False, with `out` undefined, where it takes that
  /// walk: where the plane holds vertices, and ground there is missing or level, and where rounding
  /// has a say in which edges are crossed. Cost: about 5 ns a vertex; no allocation once `out` is
  /// warm.
  bool cut(const GridPlane& plane, const URange& range, Profile& out) const;

private:
  const Grid& grid_;
  View view_;
  const TriangleSet& level_;
  double rounding_m_;
  LinePlaces places_;
};

} // namespace orograph
