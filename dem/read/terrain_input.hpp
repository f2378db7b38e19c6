// SPDX-License-Identifier: GPL-3.0-or-later
// Terrains that a program has in memory, as files might hold them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace orograph {

/// A DEM in memory: `rows` lines of `columns` heights each, line after line.
struct GridInput {
  int columns = 0, rows = 0;
  std::variant<std::span<const float>, std::span<const double>> heights; ///< columns * rows
  /// Keeps the heights alive: they are borrowed, not copied, if they lie as a Grid has them (first
  /// line in the north, first column in the west, metres, NaN for no height), and copied otherwise.
  /// Null: they are copied, and may go once the terrain is made.
  std::shared_ptr<const void> owner;
  /// GDAL's: a cell's corner at column c and row r is at x = g[0] + g[1] c + g[2] r, y = g[3] +
  /// g[4] c + g[5] r, in the units of the CRS; heights are at the cells' centres. This one has
  /// cells of size 1 and the first row in the north.
  std::array<double, 6> geotransform{0, 1, 0, 0, 0, -1};
  std::string crs; ///< WKT, "EPSG:32632" and the like; empty: none, units are metres
  double height_unit_m = 1;
  std::optional<double> nodata; ///< means no height, as NaN and infinities do
  std::string name = "heights"; ///< what messages and titles call it
};

/// A TIN in memory: triangles of three points each, in any orientation.
struct TinInput {
  std::vector<std::array<double, 3>> points;           ///< x, y in the CRS, height
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of points
  std::string crs; ///< projected, as in GridInput; empty: none, units are metres
  double height_unit_m = 1;
  bool repair = false; ///< triangles that aren't a terrain are reduced to their upper surface
  std::string name = "triangles";
};

} // namespace orograph
