// SPDX-License-Identifier: GPL-3.0-or-later
// A Delaunay triangulation of some of a grid's vertices, by their columns and rows.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace orograph {

/// A vertex of a grid.
struct LatticePoint {
  int column = 0, row = 0;
  bool operator==(const LatticePoint&) const = default;
};

/// Twice the area of a, b, c as if cells were squares of side 1, x the column and y the row;
/// positive where they run counterclockwise with y up. REQUIRES columns and rows below 2^30.
inline std::int64_t twice_area(LatticePoint a, LatticePoint b, LatticePoint c) {
  const std::int64_t bx = b.column - a.column, by = b.row - a.row;
  const std::int64_t cx = c.column - a.column, cy = c.row - a.row;
  return bx * cy - by * cx;
}

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

} // namespace orograph
