// SPDX-License-Identifier: GPL-3.0-or-later
// The quick cut of a grid by planes: line after line of its vertices, many at a time.
#pragma once

#include "dem/grid.hpp"
#include "profiles/grid_lines.hpp"
#include "profiles/profile.hpp"
#include "profiles/triangles.hpp"
#include "profiles/walk_grid.hpp"
#include "view/view.hpp"

namespace orograph {

/// Of the three families of edges (along columns, rows and diagonals) the one whose depth changes
/// most has all of its lines crossed by the plane, one after another, and between two of them there
/// is just one more crossing, of an edge of one of the other families. So the profile's vertices
/// are found by plain arithmetic on arrays.
class LineCutter {
public:
  /// REQUIRES `is_upright(grid)`, and that the grid and `level` outlive the cutter. Unless depth
  /// rises or falls along all rows, columns and diagonals in floating point as well, planes that
  /// are within `rounding_m` of a vertex aren't cut.
  LineCutter(const Grid& grid, const View& view, const TriangleSet& level, double rounding_m);

  /// Adds the profile in the plane to `out`, bit for bit that of `walk_grid`, but for what lies
  /// farther than a few vertices outside `range`. False, with `out` undefined, where it takes that
  /// walk: where the plane holds single vertices, and ground there is missing or level, and where
  /// rounding has a say in which edges are crossed. Cost: about 5 ns a vertex, or that of
  /// `cut_row`; no allocation once `out` is warm.
  bool cut(const GridPlane& plane, const URange& range, Profile& out) const;

private:
  const Grid& grid_;
  View view_;
  const TriangleSet& level_;
  double rounding_m_;
  LinePlaces places_;
};

} // namespace orograph
