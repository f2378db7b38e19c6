// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of the files that a terrain is read from.
#pragma once

#include "geometry/box.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// Which rasters are read in larger cells than their own.
struct LargeRasters {
  std::uint64_t most_heights = 0; ///< of those that are read as they are
  int least_cells = 0;            ///< along the shorter side, that are left
  bool with_nested = false;       ///< with the raster's own heights in larger cells
};

struct ReadOptions {
  std::optional<Box2> bbox; ///< in map coordinates; keeps the vertices inside it
  /// Instead of `bbox`: in degrees on WGS 84; where it lies across 180 degrees, longitudes go on
  /// beyond.
  std::optional<Box2> bbox_lonlat;

  /// Files may make GDAL ask the network for what they name. Inputs that are on the network
  /// themselves always may.
  bool allow_network = false;

  // Rasters.
  int band = 1;                          ///< counted from 1
  std::vector<std::string> open_options; ///< NAME=VALUE each, handed to GDAL's driver
  std::optional<int> overview;           ///< level from 0, the finest; none reads full heights
  std::string height_unit;               ///< as `length_unit` knows it; empty: what the file says
  std::optional<double> fill_voids;      ///< up to so many cells from a height; none leaves gaps
  /// Twice, four times, eight times ... as large, and no more of the raster is in memory than some
  /// rows. Not where voids are filled.
  std::optional<LargeRasters> large;
  /// Larger cells come from the index beside the first raster, if there is one that is right.
  bool use_index = true;

  /// Bytes; where reading and drawing a raster would take more, it is refused before it is read.
  std::optional<std::uint64_t> max_memory;

  // Triangles and points.
  std::string layer;   ///< of a vector file, or a LandXML surface's name; empty: the only one
  bool repair = false; ///< triangles that aren't a terrain are reduced to their upper surface

  // Points.
  std::array<std::string, 3> columns{"x", "y", "z"}; ///< of a text file
  std::string height_field;                          ///< of a vector file whose points have no Z
  std::string breaklines;                            ///< a vector file with lines; empty: none
  std::string boundary;                              ///< a vector file with polygons; empty: none
  std::optional<double> max_edge_m;
};

} // namespace orograph
