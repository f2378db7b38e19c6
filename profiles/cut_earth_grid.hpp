// SPDX-License-Identifier: GPL-3.0-or-later
// The exact cut of grids on the ellipsoid by planes of constant depth: a walk from triangle to
// triangle.
#pragma once

#include "dem/grid.hpp"
#include "geometry/box.hpp"
#include "profiles/border_places.hpp"
#include "profiles/profile.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <memory>
#include <optional>
#include <span>

namespace orograph {

/// Cuts one grid for one view, plane after plane, in any order; the profile is that of the TIN of
/// its triangles (`TinCutter`). Columns and rows are curved, so depth tells nothing of where a
/// plane comes in: it is looked for on the border, holes' borders too. Cost a plane: O(columns +
/// rows + border edges of about its depth), of a part O(its cells + those border edges).
class EarthGridCutter {
public:
  /// REQUIRES a grid on the ellipsoid, and that `grid` and `level` (the triangles whose spans are
  /// marked level; may be empty) outlive the cutter. `border` is the grid's `border_places`. `box`,
  /// if it is known, is that of all vertices: then parts of profiles cost less than all of them.
  EarthGridCutter(const Grid& grid, const View& view, const TriangleSet& level,
                  std::shared_ptr<const BorderPlaces> border, const Box3* box = nullptr);

  void cut(double depth_m, Profile& out) const;
  /// From the left end of the first range to the right end of the last, with the vertices next to
  /// it; more of it may be there. All of it without a box, and about the poles.
  void cut(double depth_m, std::span<const URange> ranges, Profile& out) const;

  /// Depths between which the grid's triangles lie.
  double nearest_m() const { return border_.nearest_m(); }
  double farthest_m() const { return border_.farthest_m(); }

private:
  struct ZRange {
    double low_m, high_m;
  };

  const Grid& grid_;
  View view_;
  const TriangleSet& level_;
  BorderInView border_;
  std::optional<ZRange> z_m_; ///< of all vertices
};

} // namespace orograph
