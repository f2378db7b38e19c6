// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles, points and lines as a file holds them.
#pragma once

#include "dem/terrain.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace orograph {

/// What one file holds, in map coordinates and the file's own unit of height: either triangles, or
/// points and lines. All numbers are finite but for the heights of a ring that has none.
struct MapShapes {
  std::string path;
  MapFrame map;             ///< without its origin; no CRS where the file has none
  bool units_known = false; ///< the file told the units of `map`, by its CRS or without one

  std::vector<Vec3> points; ///< scattered, or the triangles' corners
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::vector<Vec3>> breaklines;
  std::vector<std::vector<Vec3>> rings; ///< of a boundary; z is NaN in all of one or in none

  double surface_error_m = 0;
  std::vector<std::string> notes;
};

} // namespace orograph
