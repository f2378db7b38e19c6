// SPDX-License-Identifier: GPL-3.0-or-later
// The exact cut of a triangulated grid by planes of constant depth.
#pragma once

#include "dem/grid.hpp"
#include "profiles/line_cutter.hpp"
#include "profiles/profile.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <optional>
#include <span>

namespace orograph {

/// Cuts one grid for one view, plane after plane, in any order.
///
///  (1) There is a vertex wherever the plane crosses a column line, a row line or a diagonal, in
///      order from left to right, once; a plane through a grid vertex has that vertex.
///  (2) Between two vertices the profile lies in one triangle; where that isn't there is a gap. An
///      edge that lies in the plane is there if either of its triangles is, and level if either is.
///  (3) A crossing is reckoned from its edge's lower vertex (`SurfaceEdge`), exact at both ends.
///  (4) Of parts of the profile there are all vertices in them, and those next to them; more of it
///      may be there, and gaps for what isn't.
/// Cost a plane: O(columns + rows), and no allocation once `out` is warm.
class GridCutter {
public:
  /// REQUIRES a grid on a map plane (profiles/cut_mesh.hpp cuts those on the ellipsoid), and that
  /// `grid` and `level` (the triangles whose spans are marked level; may be empty)
  /// outlive the cutter.
  GridCutter(const Grid& grid, const View& view, const TriangleSet& level);

  void cut(double depth_m, Profile& out) const { cut(depth_m, kAllOfProfile, out); }
  /// The parts in `ranges`, which rise and are farther apart than 8 cells.
  void cut(double depth_m, std::span<const URange> ranges, Profile& out) const;

  /// Depths between which the grid lies.
  double nearest_m() const { return nearest_m_; }
  double farthest_m() const { return farthest_m_; }

private:
  const Grid& grid_;
  View view_;
  const TriangleSet& level_;
  double nearest_m_, farthest_m_;
  bool depth_monotone_; ///< along rows and columns, in floating point as well
  std::optional<LineCutter> by_lines_;
};

} // namespace orograph
