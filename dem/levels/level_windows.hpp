// SPDX-License-Identifier: GPL-3.0-or-later
// Which of a grid's rows or columns each vertex of a level looks at.
#pragma once

#include <vector>

namespace orograph {

/// Rows, or columns, of a grid that a vertex of a level looks at.
struct LevelWindow {
  double middle;             ///< in the grid's rows or columns
  double reach;              ///< to either side; not beyond the border, lest the ground there tilts
  int first, last;           ///< of the mean
  int first_near, last_near; ///< of the highest and the lowest

  /// Of a row or column in the mean: 1 in the middle, less beside it.
  double weight(int at) const;
  /// The one whose height a lake keeps, and whose void stays one.
  int nearest() const;
  /// The same, counted from a later row or column on.
  LevelWindow from(int start) const;
};

/// As many vertices as cells of about `step` need.
int vertices_for(int vertices, int step);

/// Of so many vertices at even steps from border to border, each up to half a cell larger or
/// smaller than `step` would be.
std::vector<LevelWindow> stretched_windows(int vertices, int made);

/// About some places among so many vertices, rising, of a level whose cells are `step` of them
/// large.
std::vector<LevelWindow> windows_about(const std::vector<double>& places, double step,
                                       int vertices);

/// How many vertices a level has that takes every `step`th one, and the last one.
int nested_vertices(int vertices, int step);

} // namespace orograph
