// SPDX-License-Identifier: GPL-3.0-or-later
// The exact cut of a grid on the ellipsoid by planes of constant depth.
#pragma once

#include "dem/grid.hpp"
#include "profiles/border_sides.hpp"
#include "profiles/grid_mesh.hpp"
#include "profiles/outline.hpp"
#include "profiles/profile.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <span>

namespace orograph {

/// Cuts one grid for one view, plane after plane, in any order; the profile is that of the TIN of
/// its triangles (`TinCutter`). Columns and rows are curved, so depth tells nothing of where a
/// plane comes in: it is looked for on the border, holes' borders too. Cost a plane: O(columns +
/// rows + border edges of about its depth).
class EarthGridCutter {
public:
  /// REQUIRES a grid on the ellipsoid, its border as `border_edges` has it, and that `grid` and
  /// `level` (the triangles whose spans are marked level; may be empty) outlive the cutter.
  EarthGridCutter(const Grid& grid, const View& view, const TriangleSet& level,
                  std::span<const BorderEdge> border);

  void cut(double depth_m, Profile& out) const;
  /// All of it, whatever the range.
  void cut(double depth_m, std::span<const URange>, Profile& out) const { cut(depth_m, out); }

  /// Depths between which the grid's triangles lie.
  double nearest_m() const { return border_.nearest_m(); }
  double farthest_m() const { return border_.farthest_m(); }

private:
  const Grid& grid_;
  View view_;
  const TriangleSet& level_;
  BorderSides<GridSide> border_;
};

} // namespace orograph
