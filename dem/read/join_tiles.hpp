// SPDX-License-Identifier: GPL-3.0-or-later
// Many rasters' vertices on one lattice.
#pragma once

#include "dem/read/raster_order.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct Tile {
  std::string path;
  RasterLattice lattice; ///< in the order of a Grid: pixels are columns, lines are rows
};

/// A tile's window of the joined lattice.
struct TilePlace {
  std::size_t tile;
  RasterWindow at;
};

struct JoinedTiles {
  RasterLattice lattice;         ///< the smallest that holds every tile; in the order of a Grid
  std::vector<TilePlace> places; ///< in the order in which the tiles were given
};

/// Where neighbouring tiles have the same row or column of vertices, it is one in the joined
/// lattice; where they have not, their last and first are neighbours. Columns and rows depend on
/// the set of tiles alone, not on their order.
///
/// `turn` is what a whole turn is in map coordinates where they count longitudes: tiles go around
/// the earth to the side at which they meet, the westmost keeping its own counting.
///
/// Throws Error where vertices aren't on one lattice within 1e-5 of a step anywhere, and where a
/// tile touches none of the others (nearest vertices more than a step apart, in rows or columns).
/// `overview` is the level they are, if any, for the message. REQUIRES at least one tile; what a
/// single one is, is never refused.
JoinedTiles join_tiles(std::vector<Tile> tiles, std::optional<double> turn,
                       std::optional<int> overview);

/// Adds places a whole turn to the west or to the east for tiles that have vertices in the window
/// there, so that a window across a tile's end is whole; none where a turn isn't a whole number of
/// columns.
void continue_around(JoinedTiles& joined, double turn, const Box2& window);

/// Moves tiles by whole turns of longitude to where they meet: the widest gap between them is cut,
/// and they follow each other eastward from it. The tile at the cut's east keeps its counting.
/// Where gaps are equally wide (there are none, around the whole earth) it is the one that begins
/// westmost as the files count.
void bring_together(std::vector<Tile>& tiles, double turn);

/// `x` plus the whole turns that bring the interval from `x` to `x + width` over most of that from
/// `low` to `high`; as few as may be.
double turned_onto(double x, double width, double low, double high, double turn);

} // namespace orograph
