// SPDX-License-Identifier: GPL-3.0-or-later
// How large a terrain's cells are on the page, and how large they are to be.
#pragma once

#include "dem/grid.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

#include <vector>

namespace orograph {

/// Of cells on the page, in mm.
struct CellSizes {
  double least_mm, most_mm; ///< smaller ones are made larger, and larger ones smaller
};

/// As `style.detail` asks, or the lines' spacing.
CellSizes asked_size(const Style& style);

/// How large a cell is on the page where it is largest; infinite where the eye stands over the
/// ground, 0 where nothing is on the page.
double greatest_cell_mm(const PlacedView& placed, const Grid& grid);

/// Whether a place, as `PlacedView::on_page` tells it, is in the picture.
bool is_on_page(const PlacedView& placed, Vec3 on_page);

/// Whether a place in plan is over the grid's ground, of whose vertices the boxes are, or at most
/// half a cell beside it.
bool stands_over(const Grid& grid, const std::vector<Box3>& boxes, Vec2 eye_m);

} // namespace orograph
