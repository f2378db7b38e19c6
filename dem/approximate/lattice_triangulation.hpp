// SPDX-License-Identifier: GPL-3.0-or-later
// A Delaunay triangulation of some of a grid's vertices, by their columns and rows; the Tin that it
// makes on the ground, and how far that is from the grid.
#pragma once

#include "dem/approximate/lattice_triangle.hpp"
#include "dem/grid.hpp"
#include "dem/tin.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace orograph {

/// Triangles over the whole rectangle of a grid, in exact whole numbers, as if cells were squares
/// in which the diagonal from (column, row) to (column + 1, row + 1) is shorter than the other one
/// by less than anything: of x^2 + y^2 - e x y with e > 0 as small as it needs to be. So
///  (1) all vertices together have the grid's own triangles, and
///  (2) any edge of those is an edge here as soon as both its ends are, because the empty circle
///      that it has among all vertices is empty among fewer; nothing has to be forced.
class LatticeTriangulation {
public:
  static constexpr std::uint32_t kNone = 0xffffffff; ///< beyond the rectangle's border

  struct Triangle {
    std::array<std::uint32_t, 3> vertices;   ///< twice_area > 0
    std::array<std::uint32_t, 3> neighbours; ///< [k] across the edge opposite to vertex k
  };

  /// The four corners and two triangles. REQUIRES columns and rows from 2 to 2^30.
  LatticeTriangulation(int columns, int rows);

  /// Adds a vertex in triangle `holder` (its edges included) and gives the triangles that are new
  /// or changed, all those around it, by number; until the next call. None goes away; numbers of
  /// new ones follow on. REQUIRES that no vertex is there.
  const std::vector<std::uint32_t>& add(LatticePoint point, std::uint32_t holder);
  /// A triangle that holds the point, looked for from `near` on. Exact; cost as many triangles as
  /// lie between. REQUIRES a point in the rectangle.
  std::uint32_t find(LatticePoint point, std::uint32_t near) const;

  const std::vector<LatticePoint>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  LatticePoint corner(const Triangle& triangle, int k) const {
    return points_[triangle.vertices[static_cast<std::size_t>(k)]];
  }

private:
  void split_inside(std::uint32_t vertex, std::uint32_t holder);
  void split_edge(std::uint32_t vertex, std::uint32_t holder, int edge);
  void flip_until_delaunay();
  void replace_neighbour(std::uint32_t of, std::uint32_t old, std::uint32_t by);
  std::uint32_t add_triangle(const Triangle& triangle);

  std::vector<LatticePoint> points_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> changed_, to_check_;
};

/// Rounds, each of about twice as many vertices as the one before and drawn as if by lot, and
/// within a round near ones after each other (biased randomized insertion order: Amenta, Choi and
/// Rote 2003). The same order on every machine.
std::vector<LatticePoint> insertion_order(const std::vector<LatticePoint>& points);

/// A Tin of some of a grid's vertices.
struct LatticeTin {
  Tin tin;
  std::vector<LatticePoint> at; ///< where its vertices are in the grid
};

/// The triangles for which `wanted` isn't 0, with the grid's positions and heights. Vertices in
/// row-major order; each triangle begins with its vertex of lowest index, and triangles are in the
/// order of their vertices, however the triangulation came about.
LatticeTin lattice_tin(const Grid& grid, const LatticeTriangulation& triangulation,
                       const std::vector<unsigned char>& wanted);

/// Greatest vertical distance at the grid's vertices: each triangle against all those that it
/// covers, its edges included. `at` tells where the Tin's vertices are in the grid. REQUIRES a Tin
/// over the grid's ground only.
double greatest_distance_at_vertices_m(const Grid& grid, const Tin& tin,
                                       const std::vector<LatticePoint>& at);

/// Greatest vertical distance where edges of the Tin cross edges of the grid (column lines, row
/// lines and diagonals) between their ends. With the one at vertices it bounds the distance
/// anywhere: both surfaces are flat on each piece of ground that is left between all those edges,
/// so that their distance is greatest at a corner of one. Cost as many edges as cross.
double greatest_distance_at_crossings_m(const Grid& grid, const Tin& tin,
                                        const std::vector<LatticePoint>& at);

} // namespace orograph
