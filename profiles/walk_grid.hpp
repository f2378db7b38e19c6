// SPDX-License-Identifier: GPL-3.0-or-later
// The cut of a grid by a plane, triangle by triangle, whatever rounding does.
#pragma once

#include "dem/grid.hpp"
#include "profiles/profile.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <cmath>
#include <limits>

namespace orograph {

/// A plane of constant depth, and how it parts vertices in near and far ones. Those in the plane
/// count as far, except where the grid only touches the plane from behind: then nothing would be
/// near.
struct GridPlane {
  double depth_m;
  bool far_at_plane;
  bool is_far(double v) const { return far_at_plane ? v >= depth_m : v > depth_m; }
  /// The least depth that is far.
  double least_far_m() const {
    return far_at_plane ? depth_m
                        : std::nextafter(depth_m, std::numeric_limits<double>::infinity());
  }
};

/// Appends to `out` the profile in the plane, as GridCutter (profiles/cut_grid.hpp) promises it.
/// `monotone`: whether depth rises or falls along all rows and columns in floating point as well,
/// so that there is one place where the plane comes in; otherwise all border edges are asked.
/// REQUIRES a grid on a map plane.
void walk_grid(const Grid& grid, const View& view, const TriangleSet& level, const GridPlane& plane,
               bool monotone, Profile& out);

} // namespace orograph
