// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/map_bounds.hpp"

namespace orograph {
namespace {

Box2 bounds_of(const DegreeLattice& lattice, double unit_deg) {
  Box2 bounds;
  for (const int column : {0, lattice.columns - 1})
    for (const int row : {0, lattice.rows - 1})
      bounds.include({lattice.lon_deg(column) / unit_deg, lattice.lat_deg(row) / unit_deg});
  return bounds;
}

Box2 bounds_of(const Grid& grid, const MapFrame& map) {
  if (grid.is_on_earth()) return bounds_of(grid.earth().degrees(), map.earth->unit_deg);
  Box2 bounds;
  for (const int column : {0, grid.columns - 1})
    for (const int row : {0, grid.rows - 1}) {
      const Vec2 ground = grid.plane().position_m(column, row);
      const Vec3 corner = map.to_map({ground.x, ground.y, 0});
      bounds.include({corner.x, corner.y});
    }
  return bounds;
}

Box2 bounds_of(const Tin& tin, const MapFrame& map) {
  Box2 bounds;
  for (const Vec3& vertex : tin.vertices_m) {
    const Vec3 at = map.to_map(vertex);
    bounds.include({at.x, at.y});
  }
  return bounds;
}

} // namespace

Box2 map_bounds(const TerrainData& terrain) {
  return std::visit([&](const auto& s) { return bounds_of(s, terrain.map); }, terrain.surface);
}

} // namespace orograph
