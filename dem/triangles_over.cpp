// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/triangles_over.hpp"

#include "dem/mesh/tin_index.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace orograph {
namespace {

// Unless it has no area seen from above, or a corner has no height.
void add(GroundTriangle corners, bool is_mirrored, std::vector<GroundTriangle>& out) {
  if (std::isnan(corners[0].z + corners[1].z + corners[2].z)) return;
  if (is_mirrored) std::swap(corners[1], corners[2]);
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  if (normal.z > 0) out.push_back(corners);
}

// Column and row of a corner of a box, at the terrain's lowest or its highest.
Vec2 column_row(const Grid& grid, Vec3 at) {
  if (grid.is_on_earth()) return grid.earth().column_row_at(at);
  const PlaneLattice& plane = grid.plane();
  const Vec2 from_first = Vec2{at.x, at.y} - plane.first_vertex_m;
  const double area = cross(plane.column_step_m, plane.row_step_m);
  return {cross(from_first, plane.row_step_m) / area,
          cross(plane.column_step_m, from_first) / area};
}

int cell_number(double number, int cells) {
  return static_cast<int>(std::clamp(std::floor(number), 0.0, cells - 1.0));
}

void add_cells(const Grid& grid, const Box3& extent, const Box2& box,
               std::vector<GroundTriangle>& out) {
  if (grid.columns < 2 || grid.rows < 2) return;
  Box2 reach;
  for (const double x : {box.low.x, box.high.x})
    for (const double y : {box.low.y, box.high.y})
      for (const double z : {extent.low.z, extent.high.z}) {
        const Vec2 at = column_row(grid, {x, y, z});
        if (!(std::isfinite(at.x) && std::isfinite(at.y))) return; // beyond the earth's limb
        reach.include(at);
      }
  if (reach.high.x < -1 || reach.high.y < -1 || reach.low.x > grid.columns ||
      reach.low.y > grid.rows)
    return;
  const bool is_mirrored = !grid.is_on_earth() && grid.plane().is_mirrored();
  // One more on either side, for rounding, and for lines that the ellipsoid bends.
  const int first = cell_number(reach.low.x - 1, grid.columns - 1),
            last = cell_number(reach.high.x + 1, grid.columns - 1);
  for (int r = cell_number(reach.low.y - 1, grid.rows - 1);
       r <= cell_number(reach.high.y + 1, grid.rows - 1); ++r)
    for (int c = first; c <= last; ++c) {
      const Vec3 corner = grid.vertex_m(c, r), opposite = grid.vertex_m(c + 1, r + 1);
      add({corner, grid.vertex_m(c, r + 1), opposite}, is_mirrored, out);
      add({corner, opposite, grid.vertex_m(c + 1, r)}, is_mirrored, out);
    }
}

} // namespace

std::vector<std::vector<GroundTriangle>>
triangles_over(const Surface& surface, const SurfaceExtent& extent, std::span<const Box2> boxes) {
  std::vector<std::vector<GroundTriangle>> out(boxes.size());
  if (const Grid* grid = std::get_if<Grid>(&surface)) {
    for (std::size_t i = 0; i < boxes.size(); ++i) add_cells(*grid, extent.box, boxes[i], out[i]);
    return out;
  }
  const Tin& tin = std::get<Tin>(surface);
  if (tin.triangles.empty()) return out;
  const TinIndex index(tin);
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    index.meeting(boxes[i], found);
    for (const std::uint32_t t : found) {
      const auto& [a, b, c] = tin.triangles[t];
      add({tin.vertices_m[a], tin.vertices_m[b], tin.vertices_m[c]}, false, out[i]);
    }
  }
  return out;
}

} // namespace orograph
