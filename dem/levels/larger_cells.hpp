// SPDX-License-Identifier: GPL-3.0-or-later
// A raster that is read in larger cells than its own, and how far these are from its heights.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/departure.hpp"
#include "dem/levels/part_of_grid.hpp"
#include "dem/levels/tops.hpp"

#include <memory>
#include <vector>

namespace orograph {

struct NestedCells;

/// A part of a raster in its own cells.
struct RasterPart {
  GridPart at; ///< of the raster's columns and rows
  Grid cells;  ///< heights alone: a frame's lattice of the raster tells where they are
};

struct LargerCells {
  int step = 1;              ///< of the raster's cells to one, about
  int columns = 0, rows = 0; ///< the raster's vertices, between the same borders
  Departure departure;
  std::vector<Top> tops;              ///< the raster's highest summits, by its own columns and rows
  std::vector<RasterPart> parts = {}; ///< what of it was read in its own cells, too
  /// The raster's own heights in larger cells, where they were asked for; else null.
  std::shared_ptr<const NestedCells> nested = {};
};

} // namespace orograph
