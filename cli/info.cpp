// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph info`.
#include "cli/info.hpp"

#include "dem/extent.hpp"
#include "dem/read/raster_bands.hpp"
#include "dem/read/read_terrain.hpp"
#include "geometry/angle.hpp"
#include "placing/terrain_facts.hpp"
#include "profiles/surface_edges.hpp"
#include "text/printable.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <string_view>

namespace orograph {
namespace {

// Names of files and of a CRS are others' words.
void add_line(std::string& text, std::string_view word, const std::string& value) {
  text += fmt::format("{:<11}{}\n", word, shortened(printable(value), 1000));
}

/// Enough digits for a millimetre in a map's coordinates, and none that aren't needed.
std::string coordinate(double x) {
  return fmt::format("{:.10g}", x);
}

std::string describe_cell(const Grid& grid) {
  const auto [column_m, row_m] = steps_of(grid);
  std::string text = fmt::format("{:.6g} x {:.6g} m", length(column_m), length(row_m));
  if (grid.is_on_earth()) {
    const DegreeLattice& lattice = grid.earth().degrees();
    return fmt::format("{:.6g} x {:.6g} degrees, {} in the middle", lattice.lon_step_deg,
                       -lattice.lat_step_deg, text);
  }
  if (column_m.y != 0 || row_m.x != 0)
    text += fmt::format(", rows run towards azimuth {:.4g} degrees", azimuth_deg(column_m));
  return text;
}

HeightRange heights_of(const Surface& surface, const SurfaceExtent& extent) {
  if (const Grid* grid = std::get_if<Grid>(&surface)) return height_range(*grid);
  return {extent.box.low.z, extent.box.high.z, extent.mean_height_m};
}

std::string describe_units(const MapFrame& map) {
  std::string text = map.unit_name;
  if (map.earth && map.earth->unit_deg != 1)
    text += fmt::format(" ({:.10g} degrees)", map.earth->unit_deg);
  if (map.unit_m != 1) text += fmt::format(" ({:.10g} m)", map.unit_m);
  text += ", heights in " + map.height_unit_name;
  if (map.height_unit_m != 1) text += fmt::format(" ({:.10g} m)", map.height_unit_m);
  return text;
}

void add_size(std::string& text, const Grid& grid) {
  add_line(text, "Size", fmt::format("{} x {} vertices", grid.columns, grid.rows));
  add_line(text, "Cell", describe_cell(grid));
}

void add_size(std::string& text, const Tin& tin) {
  add_line(text, "Size",
           fmt::format("{} vertices, {} triangles", tin.vertices_m.size(), tin.triangles.size()));
  Box2 edges; // from the shortest to the longest, in x
  std::size_t border = 0, walls = 0;
  for_each_edge(tin, [&](const TinEdge& e) {
    const Vec3 along = tin.vertices_m[e.edge.to] - tin.vertices_m[e.edge.from];
    edges.include({std::hypot(along.x, along.y), 0});
    if (e.left == kNoTriangle || e.right == kNoTriangle) ++border;
  });
  const TriangleSet is_wall = walls_of(tin);
  if (!is_wall.empty())
    for (std::size_t t = 0; t < tin.triangles.size(); ++t) walls += is_wall.has(t);
  add_line(text, "Edges",
           fmt::format("{:.4g} to {:.4g} m long seen from above, {} at the border", edges.low.x,
                       edges.high.x, border));
  if (walls > 0) add_line(text, "Walls", fmt::format("{} vertical triangles", walls));
}

void add_memory(std::string& text, const Grid& grid, const SurfaceExtent& extent) {
  const std::size_t missing = grid.size() - extent.valid;
  const auto size = static_cast<double>(grid.size());
  const bool single = std::holds_alternative<Heights<float>>(grid.heights_m);
  add_line(text, "No data",
           missing == 0 ? std::string("none")
                        : fmt::format("{:.3g} % ({} vertices)",
                                      100 * static_cast<double>(missing) / size, missing));
  add_line(text, "In memory",
           fmt::format("{}, {:.1f} MB", single ? "float32" : "float64",
                       size * (single ? sizeof(float) : sizeof(double)) / 1e6));
}

void add_memory(std::string& text, const Tin& tin, const SurfaceExtent&) {
  const std::size_t bytes = tin.vertices_m.size() * sizeof(tin.vertices_m[0]) +
                            tin.triangles.size() * 2 * sizeof(tin.triangles[0]);
  add_line(text, "In memory", fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6));
}

void add_triangulation(std::string& text, const TriangulationCounts& counts) {
  std::string points = fmt::format("{}", counts.points);
  if (counts.merged > 0)
    points += fmt::format(", {} at the place of another (heights up to {:.3g} m apart)",
                          counts.merged, counts.greatest_merged_m);
  add_line(text, "Points", points);
  if (counts.breaklines > 0) {
    std::string lines = fmt::format("{}", counts.breaklines);
    if (counts.crossings > 0)
      lines += fmt::format(", with {} crossings (heights up to {:.3g} m apart)", counts.crossings,
                           counts.greatest_crossing_m);
    add_line(text, "Breaklines", lines);
  }
  if (counts.outside > 0)
    add_line(text, "Outside", fmt::format("{} triangles beyond the boundary", counts.outside));
  if (counts.beyond_max_edge > 0)
    add_line(text, "Too long",
             fmt::format("{} triangles at the border taken away", counts.beyond_max_edge));
}

} // namespace

std::string describe(const TerrainData& terrain) {
  const Surface& surface = terrain.surface;
  const MapFrame& map = terrain.map;
  const SurfaceExtent extent = extent_of(surface);
  const Box2 bounds = map_bounds(terrain);

  std::string text;
  for (const std::string& path : terrain.paths) add_line(text, "File", path);
  std::visit([&](const auto& s) { add_size(text, s); }, surface);
  if (terrain.triangulation) add_triangulation(text, *terrain.triangulation);
  if (terrain.surface_error_m > 0)
    add_line(text, "Stands for",
             fmt::format("heights that are up to {:.4g} m away", terrain.surface_error_m));
  add_line(text, "CRS", map.crs_name);
  if (!map.vertical_crs_name.empty()) add_line(text, "Vertical", map.vertical_crs_name);
  add_line(text, "Units", describe_units(map));
  add_line(text, "Bounds",
           fmt::format("{},{},{},{} (xmin,ymin,xmax,ymax of the vertices)",
                       coordinate(bounds.low.x), coordinate(bounds.low.y),
                       coordinate(bounds.high.x), coordinate(bounds.high.y)));
  const auto [low_m, high_m, mean_m] = heights_of(surface, extent);
  std::string heights = fmt::format("{:.6g} to {:.6g} m, mean {:.6g} m", low_m, high_m, mean_m);
  if (map.height_unit_m != 1)
    heights += fmt::format(" ({:.6g} to {:.6g} in the file's unit)", low_m / map.height_unit_m,
                           high_m / map.height_unit_m);
  add_line(text, "Heights", heights);
  std::visit([&](const auto& s) { add_memory(text, s, extent); }, surface);
  for (const auto& note : terrain.notes) add_line(text, "Note", note);
  return text;
}

void info(const InfoSettings& settings) {
  std::string text = describe(read_terrain(settings.inputs, settings.reading));
  const IndexState index = index_state(settings.inputs, settings.reading);
  if (!index.steps.empty())
    add_line(text, "Index",
             fmt::format("{}: cells {} to {} times as large", index_path(settings.inputs),
                         index.steps.front(), index.steps.back()));
  if (!index.why_not.empty()) add_line(text, "Index", index.why_not);
  std::fwrite(text.data(), 1, text.size(), stdout);
}

} // namespace orograph
