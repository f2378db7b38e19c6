// SPDX-License-Identifier: GPL-3.0-or-later
// A terrain in degrees about another origin.
#include "dem/terrain.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace orograph {
namespace {

// Straight through the earth, from the origin to the lattice's border.
struct Reach {
  double nearest_m = std::numeric_limits<double>::infinity(), farthest_m = 0;
};
Reach reach(const EarthLattice& earth) {
  const int columns = earth.degrees().columns, rows = earth.degrees().rows;
  Reach found;
  const auto take = [&](int column, int row) {
    const double away_m = length(earth.vertex_m(column, row, 0));
    found.nearest_m = std::min(found.nearest_m, away_m);
    found.farthest_m = std::max(found.farthest_m, away_m);
  };
  for (int column = 0; column < columns; ++column)
    for (const int row : {0, rows - 1}) take(column, row);
  for (int row = 0; row < rows; ++row)
    for (const int column : {0, columns - 1}) take(column, row);
  return found;
}

bool holds_origin(const EarthLattice& earth) {
  const Vec2 at = earth.column_row_at({0, 0, 0});
  const DegreeLattice& lattice = earth.degrees();
  return at.x >= 0 && at.y >= 0 && at.x <= lattice.columns - 1 && at.y <= lattice.rows - 1;
}

std::string bounds_in_words(const DegreeLattice& lattice) {
  const auto [west, east] = std::minmax({lattice.lon_deg(0), lattice.lon_deg(lattice.columns - 1)});
  const auto [south, north] = std::minmax({lattice.lat_deg(0), lattice.lat_deg(lattice.rows - 1)});
  return fmt::format("longitudes {:.10g} and {:.10g}, latitudes {:.10g} and {:.10g}", west, east,
                     south, north);
}

} // namespace

void reframe(TerrainData& terrain, double lon_deg, double lat_deg, double exaggeration) {
  Grid& grid = std::get<Grid>(terrain.surface);
  EarthFrame& frame = *terrain.map.earth;
  frame.local = LocalFrame(lon_deg, lat_deg, frame.local.ellipsoid());
  frame.exaggeration = exaggeration;
  const EarthLattice earth(grid.earth().degrees(), frame.local, exaggeration);
  // A chord as long as the earth's radius spans 60 degrees.
  const double limit_m = frame.local.ellipsoid().semi_major_axis_m;
  const auto [nearest_m, farthest_m] = reach(earth);
  if (nearest_m > limit_m && !holds_origin(earth))
    throw Error(
        fmt::format("{} is {:.0f} km away from the place that the view is about", terrain.source,
                    nearest_m / 1000),
        fmt::format("give one near it: it lies between {}", bounds_in_words(earth.degrees())));
  if (farthest_m > limit_m)
    throw Error(fmt::format("{} reaches {:.0f} km from the place that the view is about",
                            terrain.source, farthest_m / 1000),
                "`bbox` keeps the part of it that is to be seen");
  grid.lattice = earth;
}

} // namespace orograph
