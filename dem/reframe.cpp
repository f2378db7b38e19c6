// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/reframe.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace orograph {
namespace {

// Straight through the earth, from the origin to the farthest of the lattice's border.
double farthest_m(const EarthLattice& earth) {
  const int columns = earth.degrees().columns, rows = earth.degrees().rows;
  double farthest = 0;
  const auto take = [&](int column, int row) {
    farthest = std::max(farthest, length(earth.vertex_m(column, row, 0)));
  };
  for (int column = 0; column < columns; ++column)
    for (const int row : {0, rows - 1}) take(column, row);
  for (int row = 0; row < rows; ++row)
    for (const int column : {0, columns - 1}) take(column, row);
  return farthest;
}

} // namespace

void reframe(Terrain& terrain, double lon_deg, double lat_deg, double exaggeration) {
  Grid& grid = std::get<Grid>(terrain.surface);
  EarthFrame& frame = *terrain.map.earth;
  frame.local = LocalFrame(lon_deg, lat_deg, frame.local.ellipsoid());
  frame.exaggeration = exaggeration;
  const EarthLattice earth(grid.earth().degrees(), frame.local, exaggeration);
  // A chord as long as the earth's radius spans 60 degrees.
  const double farthest = farthest_m(earth);
  if (farthest > frame.local.ellipsoid().semi_major_axis_m)
    throw Error(fmt::format("{} reaches {:.0f} km from the place that the view is about",
                            terrain.source, farthest / 1000),
                "--bbox keeps the part of it that is to be seen");
  grid.lattice = earth;
}

} // namespace orograph
