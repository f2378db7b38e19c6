// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph info`.
#include "cli/info.hpp"

#include "dem/extent.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string_view>

namespace orograph {
namespace {

void add_line(std::string& text, std::string_view word, const std::string& value) {
  text += fmt::format("{:<11}{}\n", word, value);
}

/// Enough digits for a millimetre in a map's coordinates, and none that aren't needed.
std::string coordinate(double x) {
  return fmt::format("{:.10g}", x);
}

/// Clockwise from north, 0 to 360.
double azimuth_deg(Vec2 direction) {
  const double deg = std::atan2(direction.x, direction.y) * 180 / std::numbers::pi;
  return deg < 0 ? deg + 360 : deg;
}

std::string describe_cell(const Grid& grid) {
  std::string text =
      fmt::format("{:.6g} x {:.6g} m", length(grid.column_step_m), length(grid.row_step_m));
  if (grid.column_step_m.y != 0 || grid.row_step_m.x != 0)
    text +=
        fmt::format(", rows run towards azimuth {:.4g} degrees", azimuth_deg(grid.column_step_m));
  return text;
}

std::string describe_units(const MapFrame& map) {
  std::string text = map.unit_name;
  if (map.unit_m != 1) text += fmt::format(" ({:.10g} m)", map.unit_m);
  text += ", heights in " + map.height_unit_name;
  if (map.height_unit_m != 1) text += fmt::format(" ({:.10g} m)", map.height_unit_m);
  return text;
}

Box2 map_bounds(const Terrain& terrain) {
  const Grid& grid = terrain.grid;
  Box2 bounds;
  for (const int column : {0, grid.columns - 1})
    for (const int row : {0, grid.rows - 1}) {
      const Vec2 ground = grid.position_m(column, row);
      const Vec3 map = terrain.map.to_map({ground.x, ground.y, 0});
      bounds.include({map.x, map.y});
    }
  return bounds;
}

} // namespace

std::string describe(const Terrain& terrain) {
  const Grid& grid = terrain.grid;
  const MapFrame& map = terrain.map;
  const SurfaceExtent extent = extent_of(grid);
  const bool single = std::holds_alternative<std::vector<float>>(grid.heights_m);
  const std::size_t missing = grid.size() - extent.valid;
  const auto size = static_cast<double>(grid.size());
  const Box2 bounds = map_bounds(terrain);

  std::string text;
  add_line(text, "File", terrain.source);
  add_line(text, "Size", fmt::format("{} x {} vertices", grid.columns, grid.rows));
  add_line(text, "Cell", describe_cell(grid));
  add_line(text, "CRS", map.crs_name);
  add_line(text, "Units", describe_units(map));
  add_line(text, "Bounds",
           fmt::format("{},{},{},{} (xmin,ymin,xmax,ymax of the vertices)",
                       coordinate(bounds.low.x), coordinate(bounds.low.y),
                       coordinate(bounds.high.x), coordinate(bounds.high.y)));
  std::string heights = fmt::format("{:.6g} to {:.6g} m, mean {:.6g} m", extent.box.low.z,
                                    extent.box.high.z, extent.mean_height_m);
  if (map.height_unit_m != 1)
    heights +=
        fmt::format(" ({:.6g} to {:.6g} in the file's unit)", extent.box.low.z / map.height_unit_m,
                    extent.box.high.z / map.height_unit_m);
  add_line(text, "Heights", heights);
  add_line(text, "No data",
           missing == 0 ? std::string("none")
                        : fmt::format("{:.3g} % ({} vertices)",
                                      100 * static_cast<double>(missing) / size, missing));
  add_line(text, "In memory",
           fmt::format("{}, {:.1f} MB", single ? "float32" : "float64",
                       size * (single ? sizeof(float) : sizeof(double)) / 1e6));
  for (const auto& note : terrain.notes) add_line(text, "Note", note);
  return text;
}

void info(const InfoSettings& settings) {
  const std::string text = describe(read_raster(settings.input, settings.raster));
  std::fwrite(text.data(), 1, text.size(), stdout);
}

} // namespace orograph
