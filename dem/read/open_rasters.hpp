// SPDX-License-Identifier: GPL-3.0-or-later
// Rasters of one terrain, opened and joined, before any height of them is read.
#pragma once

#include "dem/grid.hpp"
#include "dem/read/join_tiles.hpp"
#include "dem/read/raster_source.hpp"
#include "dem/terrain.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct RasterSet {
  std::vector<RasterSource> sources; ///< open where it is one, else closed
  JoinedTiles joined;
  RasterWindow window;     ///< of the joined lattice, which is asked for
  std::optional<Box2> box; ///< the same in map coordinates, if it isn't all
  GridOrder order;         ///< of the window
  TerrainData terrain;     ///< without its surface and what reading heights notes
  Grid grid;               ///< the window's, without heights

  /// Whether float holds all heights.
  bool are_floats() const;
};

/// Throws Error as `read_rasters` does before it reads a height. `on_lattice` as of `open_source`.
RasterSet open_rasters(const std::vector<std::string>& paths, const ReadOptions& options,
                       const std::function<void(const RasterSource&)>& on_lattice = {});

} // namespace orograph
