// SPDX-License-Identifier: GPL-3.0-or-later
// Terrains in degrees from a formula, and where their places are by GeographicLib alone.
#pragma once

#include "dem/terrain.hpp"

#include <GeographicLib/LocalCartesian.hpp>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace orograph {

/// Of a place in degrees, in metres.
using HeightOfPlace = std::function<double(double lon_deg, double lat_deg)>;

inline TerrainData earth_terrain(const DegreeLattice& lattice, const HeightOfPlace& height_m,
                                 const Ellipsoid& ellipsoid = {}) {
  TerrainData terrain;
  const double lat_deg = lattice.lat_deg(lattice.rows / 2);
  const LocalFrame frame(lattice.lon_deg(lattice.columns / 2), lat_deg, ellipsoid);
  std::vector<double> heights;
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column)
      heights.push_back(height_m(lattice.lon_deg(column), lattice.lat_deg(row)));
  terrain.surface =
      Grid{lattice.columns, lattice.rows, EarthLattice(lattice, frame), std::move(heights)};
  terrain.source = "made.tif";
  terrain.map.earth = EarthFrame{frame};
  terrain.map.origin = {lattice.first_lon_deg, lattice.first_lat_deg};
  terrain.map.crs_wkt = "EPSG:4326";
  terrain.map.crs_name = "WGS 84";
  terrain.map.unit_name = "degree";
  terrain.map.radii = CurvatureRadii{euler_radius_m(ellipsoid, lat_deg, Angle()),
                                     euler_radius_m(ellipsoid, lat_deg, Angle::degrees(90))};
  return terrain;
}

/// East, north and up of a place on WGS 84 about another, which lies at height 0.
inline Vec3 local_cartesian_m(Vec3 lonlat_h, Vec3 about) {
  const GeographicLib::LocalCartesian frame(about.y, about.x, 0,
                                            GeographicLib::Geocentric::WGS84());
  Vec3 p;
  frame.Forward(lonlat_h.y, lonlat_h.x, lonlat_h.z, p.x, p.y, p.z);
  return p;
}

} // namespace orograph
