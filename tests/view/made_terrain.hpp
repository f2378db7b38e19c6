// SPDX-License-Identifier: GPL-3.0-or-later
// Terrains for views, and the picture of a point by a pinhole camera, from its definition.
#pragma once

#include "dem/extent.hpp"
#include "tests/support/made_grid.hpp"
#include "view/place_view.hpp"

#include <memory>
#include <numbers>

namespace orograph {

struct MadeTerrain {
  std::unique_ptr<Grid> grid; ///< stays where it is: the extent refers to it
  SurfaceExtent extent;
  std::vector<OutlineEdge> outline;
  std::vector<Vec3> vertices; ///< those with a height

  TerrainShape shape() const {
    return {extent.blocks, outline, extent.box, extent.mean_height_m, cell_size_m(*grid)};
  }
};

inline MadeTerrain made_terrain(Random& random, int most_vertices, double missing = 0) {
  GridLattice lattice =
      turned_lattice(random.whole(2, most_vertices), random.whole(2, most_vertices),
                     {random.between(5, 30), random.between(5, 30)}, random.between(-0.7, 0.7));
  lattice.first_vertex_m = {random.between(-300, 300), random.between(-300, 300)};
  MadeTerrain terrain;
  const double low = random.pick({0.0, 1500.0});
  do {
    terrain.grid = std::make_unique<Grid>(
        made_grid(random, lattice, {low, low + random.pick({20.0, 200.0}), missing, false, false}));
  } while (triangles_of(*terrain.grid).empty());
  terrain.extent = extent_of(*terrain.grid);
  for (const auto& [from, to] : outline_by_triangles(*terrain.grid))
    terrain.outline.push_back({vertex_m(*terrain.grid, from), vertex_m(*terrain.grid, to)});
  for (std::uint32_t i = 0; i < terrain.grid->size(); ++i)
    if (!std::isnan(vertex_m(*terrain.grid, i).z))
      terrain.vertices.push_back(vertex_m(*terrain.grid, i));
  return terrain;
}

/// A camera by three unit vectors; heights are exaggerated.
struct Pinhole {
  Vec3 eye, axis, right, up;
  bool parallel = false;

  /// Metres along the axis from the eye.
  double along(Vec3 p) const { return dot(p - eye, axis); }
  Vec2 picture(Vec3 p) const {
    const double scale = parallel ? 1 : 1 / along(p);
    return {scale * dot(p - eye, right), scale * dot(p - eye, up)};
  }
};

/// The camera at `eye` that looks along `axis`, with `upward` (not along the axis) upwards in the
/// picture, which is then turned clockwise by `roll_deg`.
inline Pinhole pinhole(Vec3 eye, Vec3 axis, double roll_deg, Vec3 upward = {0, 0, 1}) {
  axis = (1 / length(axis)) * axis;
  const Vec3 flat = cross(axis, upward);
  const Vec3 right = (1 / length(flat)) * flat, up = cross(right, axis);
  const double roll = roll_deg * std::numbers::pi / 180, s = std::sin(roll), c = std::cos(roll);
  // Where the camera turns counterclockwise, the picture turns clockwise.
  return {eye, axis, c * right + s * up, c * up - s * right};
}

inline Vec3 exaggerated(Vec3 p, double exaggeration) {
  return {p.x, p.y, p.z * exaggeration};
}

/// What the view makes of a ground point.
inline Vec2 picture_of(const View& view, Vec3 ground_m) {
  return view.to_picture(project(view, to_profile_frame(view, ground_m)));
}

inline double largest(Vec2 p) {
  return std::max(std::abs(p.x), std::abs(p.y));
}

} // namespace orograph
