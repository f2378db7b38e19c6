// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/terrain_facts.hpp"

#include <algorithm>
#include <memory>

namespace orograph {

std::vector<BorderEdge> border_of(const Surface& surface) {
  if (const Grid* grid = std::get_if<Grid>(&surface)) return border_edges(*grid, false);
  return border_edges(std::get<Tin>(surface));
}

double chosen_exaggeration(const Box3& terrain) {
  const Vec3 size = terrain.high - terrain.low;
  const double steepness = size.z / std::max(size.x, size.y);
  return steepness >= 0.12 ? 1 : steepness >= 0.06 ? 1.5 : 2;
}

double exaggeration_of(const ViewSpec& view, const Box3& terrain) {
  if (view.exaggeration) return *view.exaggeration;
  if (view.file) return view.file->exaggeration;
  return view.has_eye() || terrain.empty() ? 1 : chosen_exaggeration(terrain);
}

namespace {

TerrainFacts facts_of(const Grid& grid) {
  TerrainFacts facts;
  facts.extent = extent_of(grid);
  facts.cell_m = cell_size_m(grid);
  facts.reach_m = reach_m(grid);
  facts.border = border_edges(grid, facts.extent.valid == grid.size());
  if (grid.is_on_earth())
    facts.for_cutters.of_earth_grid =
        std::make_shared<const BorderPlaces>(border_places(grid, facts.border));
  facts.outline = outline_of(grid, facts.border);
  facts.water = find_water(grid);
  return facts;
}

} // namespace

TerrainFacts facts_of(const Tin& tin, const std::function<LevelGround()>& find_level,
                      bool with_index) {
  TerrainFacts facts;
  facts.extent = extent_of(tin);
  facts.cell_m = cell_size_m(tin);
  facts.reach_m = reach_m(tin);
  facts.border = border_edges(tin);
  facts.outline = outline_of(tin, facts.border);
  facts.for_cutters.of_tin = std::make_shared<const TinPlaces>(tin_places(tin));
  if (with_index) facts.for_cutters.tin_index = std::make_shared<const TinIndex>(tin);
  facts.water = find_level();
  return facts;
}

TerrainFacts facts_of(const TerrainData& terrain) {
  if (!has_ground(terrain.surface)) return {};
  if (const Grid* grid = std::get_if<Grid>(&terrain.surface)) return facts_of(*grid);
  const Tin& tin = std::get<Tin>(terrain.surface);
  return facts_of(
      tin, [&] { return find_water(tin); }, false);
}

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
  const auto include = [&](std::uint32_t vertex) {
    const Vec3 at = map.to_map(tin.vertices_m[vertex]);
    bounds.include({at.x, at.y});
  };
  if (map.earth) { // whose places are a microsecond each: those of the border
    for (const BorderEdge& edge : border_edges(tin)) {
      include(edge.edge.from);
      include(edge.edge.to);
    }
    return bounds;
  }
  for (std::uint32_t i = 0; i < tin.vertices_m.size(); ++i) include(i);
  return bounds;
}

} // namespace

Box2 map_bounds(const TerrainData& terrain) {
  return std::visit([&](const auto& s) { return bounds_of(s, terrain.map); }, terrain.surface);
}

} // namespace orograph
