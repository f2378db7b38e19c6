// SPDX-License-Identifier: GPL-3.0-or-later
// The profile in a plane that holds a row or a column of a grid's vertices: these are its vertices.
#pragma once

#include "dem/grid.hpp"
#include "profiles/line_places.hpp"
#include "profiles/profile.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

namespace orograph {

/// Adds the profile at `depth_m` to `out`, bit for bit that of `walk_grid`, but for what lies
/// farther than a few vertices outside `range`. False, with nothing added, where the plane doesn't
/// hold a whole row or column. Cost: about 2 ns a vertex of a row, 10 of a column, whose heights
/// are far apart in memory; no allocation once `out` is warm. REQUIRES that `places` are those of
/// the grid in the view, and depth rises or falls from row to row, or from column to column, in
/// floating point as well.
bool cut_row(const Grid& grid, const View& view, const TriangleSet& level, const LinePlaces& places,
             double depth_m, const URange& range, Profile& out);

} // namespace orograph
