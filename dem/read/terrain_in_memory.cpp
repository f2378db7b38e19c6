// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/terrain_in_memory.hpp"

#include "dem/read/crs_frame.hpp"
#include "dem/read/grid_in_frame.hpp"
#include "dem/read/length_units.hpp"
#include "dem/read/map_shapes.hpp"
#include "dem/read/raster_order.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace orograph {
namespace {

MapFrame map_frame(const std::string& crs_text, const std::string& name, double height_unit_m,
                   FileKind kind, Vec2 centre) {
  MapFrame map;
  map.crs_name = "none";
  if (!crs_text.empty()) {
    const Crs crs = crs_from_text(crs_text);
    if (!crs || !tells_place(crs.get()))
      throw Error(fmt::format("{}: '{}' is no CRS that tells a place", name, crs_text),
                  "give WKT, or a code such as EPSG:32632");
    set_crs(map, *crs, name, kind, centre);
  }
  if (!(height_unit_m > 0 && std::isfinite(height_unit_m)))
    throw Error(fmt::format("{}: heights in units of {} m", name, height_unit_m),
                "1 for metres, 0.3048 for feet", ErrorCode::request);
  map.height_unit_m = height_unit_m;
  map.height_unit_name = unit_name(height_unit_m);
  return map;
}

RasterLattice lattice_of(const GridInput& input) {
  const auto& g = input.geotransform;
  const Vec2 column_step{g[1], g[4]}, row_step{g[2], g[5]};
  return {input.columns, input.rows, Vec2{g[0], g[3]} + 0.5 * (column_step + row_step), column_step,
          row_step};
}

void check_sizes(const GridInput& input) {
  if (input.columns < 2 || input.rows < 2)
    throw Error(fmt::format("{}: {} columns and {} rows are no surface", input.name, input.columns,
                            input.rows),
                "two of each make a cell", ErrorCode::request);
  const auto wanted =
      static_cast<std::size_t>(input.columns) * static_cast<std::size_t>(input.rows);
  const std::size_t given = std::visit([](const auto& h) { return h.size(); }, input.heights);
  if (given != wanted)
    throw Error(fmt::format("{}: {} heights for {} columns and {} rows", input.name, given,
                            input.columns, input.rows),
                fmt::format("give {} heights", wanted), ErrorCode::request);
}

template <class Value>
bool is_missing(Value value, std::optional<double> nodata) {
  return !std::isfinite(value) || (nodata && value == static_cast<Value>(*nodata));
}

// Whether a Grid could have them as they are.
template <class Value>
bool is_as_in_grid(std::span<const Value> heights, const GridInput& input, const GridOrder& order) {
  if (order.transposed || order.columns_reversed || order.rows_reversed || input.height_unit_m != 1)
    return false;
  for (const Value height : heights)
    if (is_missing(height, input.nodata) && !std::isnan(height)) return false;
  return true;
}

template <class Value>
Heights<Value> heights_in_order(std::span<const Value> heights, const GridInput& input,
                                const GridOrder& order) {
  if (input.owner && is_as_in_grid(heights, input, order)) return {heights, input.owner};
  std::vector<Value> out(heights.size());
  std::size_t from = 0;
  for (int line = 0; line < input.rows; ++line)
    for (int pixel = 0; pixel < input.columns; ++pixel, ++from) {
      const Value raw = heights[from];
      out[static_cast<std::size_t>(order.start + pixel * order.per_pixel + line * order.per_line)] =
          is_missing(raw, input.nodata)
              ? std::numeric_limits<Value>::quiet_NaN()
              : static_cast<Value>(static_cast<double>(raw) * input.height_unit_m);
    }
  return out;
}

} // namespace

TerrainData terrain_of(const GridInput& input) {
  check_sizes(input);
  const RasterLattice lattice = lattice_of(input);
  if (!spans_a_plane(lattice))
    throw Error(input.name + ": columns and rows run along one line, or not at all",
                "give a geotransform whose steps span a plane", ErrorCode::request);
  TerrainData terrain;
  terrain.source = input.name;
  terrain.paths = {input.name};
  const Vec2 centre = box_of(lattice).centre();
  terrain.map = map_frame(input.crs, input.name, input.height_unit_m, FileKind::raster, centre);
  const GridOrder order = grid_order(lattice);
  terrain.map.origin = order.first;
  set_centre(terrain.map, centre);
  Grid grid = empty_grid(order, terrain.map, terrain.paths);
  std::visit([&](const auto& heights) { grid.heights_m = heights_in_order(heights, input, order); },
             input.heights);
  if (!has_height(grid))
    throw Error(input.name + " holds no heights, nodata only", "give some heights");
  terrain.surface = std::move(grid);
  return terrain;
}

TerrainData terrain_of(const TinInput& input) {
  MapShapes shapes;
  shapes.path = input.name;
  Box2 box;
  for (const auto& [x, y, z] : input.points) {
    shapes.points.push_back({x, y, z});
    box.include({x, y});
  }
  for (const auto& corners : input.triangles)
    for (const std::uint32_t corner : corners)
      if (corner >= input.points.size())
        throw Error(fmt::format("{}: a triangle has point {}, and there are {}", input.name, corner,
                                input.points.size()),
                    "points count from 0", ErrorCode::request);
  if (input.triangles.empty())
    throw Error(input.name + " holds no triangles", "give some", ErrorCode::request);
  shapes.triangles = input.triangles;
  shapes.map = map_frame(input.crs, input.name, input.height_unit_m, FileKind::other, box.centre());
  shapes.units_known = true;
  ReadOptions options;
  options.repair = input.repair;
  TerrainData terrain = terrain_from_triangles(std::move(shapes), options);
  terrain.paths = {input.name};
  return terrain;
}

} // namespace orograph
