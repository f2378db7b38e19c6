// SPDX-License-Identifier: GPL-3.0-or-later
// Cells as large as may be while no point of the ground moves on the page by more than is asked
// (docs/decisions/0062-certified-levels.md).
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/departure.hpp"
#include "dem/levels/height_ranges.hpp"
#include "dem/levels/nested_cells.hpp"
#include "dem/levels/patches.hpp"
#include "placing/placed_view.hpp"

#include <vector>

namespace orograph {

/// Bounds on what heights are on the page, wherever the view shows them: no estimates.
class HeightOnPage {
public:
  /// REQUIRES a view of that grid; both outlive this.
  HeightOnPage(const Grid& grid, const PlacedView& placed);
  /// The same of a grid of which the lattice alone is there. `heights` are its.
  HeightOnPage(const Grid& grid, const PlacedView& placed, HeightRanges heights);

  /// Of a part, its own height apart: by how many millimetres a point of it moves on the page, at
  /// most, if it is moved up or down by this and stays between the lowest and the highest ground
  /// there. Infinite where the part is at the eye; 0 where all of it is behind.
  double moves_mm(const PatchPlace& part, double departure_m) const;

  /// How far a straight edge in the ground frame may lie below or beside the same edge of the
  /// file's, whose vertices are on the round earth; 0 on a plane.
  double sag_m(int level) const;

private:
  Box3 box_of(const PatchPlace& part, const PartHeights& heights) const;
  struct Depths {
    double least, greatest;
  };
  Depths depths(const Box3& box) const;

  const Grid& grid_;
  const PlacedView& placed_;
  HeightRanges heights_;
  double cell_m_;
  bool is_round_;
};

/// Patches of the file's cells and larger ones whose heights are the file's at their vertices.
/// REQUIRES `heights` of that grid. No point of what `patchwork` makes of them is, on the page, off
/// by more than `most_mm`. Patches with a void, and those that a level's cells don't part evenly at
/// the grid's end, are of the file's cells. Cost: 1 to 3 ns a height of the grid for each level
/// that is tried.
Patches certified_patches(const Grid& grid, const HeightOnPage& heights, double most_mm);

/// The same of a raster that isn't in memory, whose lattice is `raster`. REQUIRES that `cells` are
/// its. Cost: that of looking at each patch.
Patches certified_patches(const Grid& raster, const NestedCells& cells, const HeightOnPage& heights,
                          double most_mm);

/// By how much a point is off at most, on the page. `departures` are those of the patchwork.
double greatest_error_mm(const Patches& patches, const std::vector<Departure>& departures,
                         const HeightOnPage& heights);

} // namespace orograph
