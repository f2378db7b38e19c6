// SPDX-License-Identifier: GPL-3.0-or-later
// Random grids on the ellipsoid, with gaps of every kind, for tests by definition.
#pragma once

#include "dem/grid.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace orograph {

/// Where a lattice of degrees lies; its origin is the ground frame's.
struct MadeEarth {
  int columns = 6, rows = 6;
  double west_deg = 7, north_deg = 46, lon_step_deg = 0.01, lat_step_deg = 0.01;
  double origin_lon_deg = 7, origin_lat_deg = 46, exaggeration = 1;
  Ellipsoid ellipsoid{};
};

inline EarthLattice earth_lattice(const MadeEarth& made) {
  return EarthLattice({made.west_deg, made.lon_step_deg, made.columns, made.north_deg,
                       -made.lat_step_deg, made.rows},
                      LocalFrame(made.origin_lon_deg, made.origin_lat_deg, made.ellipsoid),
                      made.exaggeration);
}

/// Takes heights away: here and there, in rectangles, all but rectangles, or from one side in.
template <class Height>
void make_gaps(Random& random, int columns, int rows, std::vector<Height>& heights) {
  constexpr Height kNone = std::numeric_limits<Height>::quiet_NaN();
  const auto fill = [&](int column, int row, int wide, int high, std::vector<Height>& out,
                        const std::vector<Height>& with) {
    for (int r = std::max(row, 0); r < std::min(row + high, rows); ++r)
      for (int c = std::max(column, 0); c < std::min(column + wide, columns); ++c) {
        const auto i = static_cast<std::size_t>(r * columns + c);
        out[i] = with[i];
      }
  };
  const std::vector<Height> nothing(heights.size(), kNone), all = heights;
  const auto rectangles = [&](int count, std::vector<Height>& out,
                              const std::vector<Height>& with) {
    for (int i = 0; i < count; ++i)
      fill(random.whole(-1, columns - 1), random.whole(-1, rows - 1),
           random.whole(1, 1 + columns / 3), random.whole(1, 1 + rows / 3), out, with);
  };
  switch (random.whole(0, 3)) {
  case 0: {
    const double share = random.pick({0.02, 0.1, 0.4});
    for (Height& height : heights)
      if (random.chance(share)) height = kNone;
    break;
  }
  case 1:
    rectangles(random.whole(1, 6), heights, nothing);
    break;
  case 2:
    heights = nothing;
    rectangles(random.whole(1, 8), heights, all);
    break;
  default: // a slanting edge
    for (int r = 0; r < rows; ++r) fill(0, r, r * columns / (2 * rows) + 1, 1, heights, nothing);
  }
}

/// Triangles that run clockwise, or are upright, seen from above: cliffs that lean over.
inline std::size_t leaning_triangles(const Grid& grid) {
  std::size_t count = 0;
  for (const GridTriangle& t : triangles_of(grid)) {
    const Vec3 a = grid.vertex_m(t.vertices[0]), b = grid.vertex_m(t.vertices[1]),
               c = grid.vertex_m(t.vertices[2]);
    const long double ux = static_cast<long double>(b.x) - a.x,
                      uy = static_cast<long double>(b.y) - a.y,
                      wx = static_cast<long double>(c.x) - a.x,
                      wy = static_cast<long double>(c.y) - a.y;
    // Not to be told from an upright one, if need be.
    const long double one = ux * wy, other = uy * wx;
    count += !(one - other > 1e-12L * (std::abs(one) + std::abs(other)));
  }
  return count;
}

/// From latitude -85 to 85, across 180 degrees as elsewhere, its frame's origin inside, beside or
/// far away, from 2x2 vertices to `most` a side; in one of three with a column on the origin's
/// meridian or a row on the equator, which then lie in planes of one depth.
inline MadeEarth random_earth(Random& random, int most) {
  MadeEarth made;
  made.columns = random.chance(0.2) ? random.whole(2, 4) : random.whole(2, most);
  made.rows = random.chance(0.2) ? random.whole(2, 4) : random.whole(2, most);
  made.lon_step_deg =
      random.pick({1.0 / 3600, 1.0 / 1200, 1.0 / 64, 0.2, random.between(0.001, 0.2)});
  made.lat_step_deg =
      random.chance(0.7) ? made.lon_step_deg : random.between(0.3, 1) * made.lon_step_deg;
  made.exaggeration = random.pick({1.0, 3.0});
  const double wide = (made.columns - 1) * made.lon_step_deg,
               high = (made.rows - 1) * made.lat_step_deg;
  made.origin_lon_deg = random.pick({180.0, -180.0, 0.0, 359.75, random.between(-180, 180)});
  made.origin_lat_deg = random.pick({0.0, 85.0, -85.0, random.between(-85, 85)});
  // Of the origin, from the north-west corner.
  double east = random.between(0, wide), south = random.between(0, high);
  const int place = random.whole(0, 3);
  if (place == 1) east -= random.pick({-1.2, 1.2}) * wide;
  if (place == 2) south -= random.pick({-1.2, 1.2}) * high;
  if (place == 3) {
    east += random.between(-25, 25);
    south += random.between(-20, 20);
  }
  if (random.chance(0.3)) { // of a column and a row
    east = made.lon_step_deg * std::round(east / made.lon_step_deg);
    south = made.lat_step_deg * std::round(south / made.lat_step_deg);
  }
  made.west_deg = made.origin_lon_deg - east;
  made.north_deg = std::clamp(made.origin_lat_deg + south, high - 89, 89.0);
  if (random.chance(0.2)) made.west_deg += 360; // counted in another turn
  return made;
}

/// Level sea, low hills, mountains or cliffs, whole metres or not, float or double; in half of them
/// with gaps.
inline Grid made_earth_grid(Random& random, const MadeEarth& made) {
  GridHeights heights;
  heights.low = random.pick({0.0, -100.0});
  heights.high = heights.low + random.pick({0.0, 3.0, 50.0, 1000.0, 4000.0});
  heights.whole = random.chance(0.3);
  heights.in_double = random.chance(0.5);
  Grid grid = made_grid(random, {made.columns, made.rows}, heights);
  grid.lattice = earth_lattice(made);
  if (random.chance(0.5))
    std::visit(
        [&](auto& of_grid) {
          std::vector with_gaps(of_grid.begin(), of_grid.end());
          make_gaps(random, grid.columns, grid.rows, with_gaps);
          of_grid = std::move(with_gaps);
        },
        grid.heights_m);
  return grid;
}

} // namespace orograph
