// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/approximate/approximate_grid.hpp"

#include "dem/approximate/lattice_triangle.hpp"
#include "dem/approximate/lattice_triangulation.hpp"
#include "geometry/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace orograph {
namespace {

struct GridOutline {
  std::size_t triangles = 0; ///< of the whole grid
  // Vertices where a triangle that is there meets one that isn't: row-major. Where the outline is
  // the grid's own end, only those at which it leaves that.
  std::vector<LatticePoint> vertices;
};

// As many triangles as a vertex would have around it in a grid without gaps.
int triangles_possible(const Grid& grid, int column, int row) {
  const int west = column > 0, east = column + 1 < grid.columns;
  const int north = row > 0, south = row + 1 < grid.rows;
  return north * (2 * west + east) + south * (west + 2 * east);
}

GridOutline outline_of(const Grid& grid) {
  GridOutline outline;
  std::visit(
      [&](const auto& heights) {
        CellRow north(grid.columns), south(grid.columns);
        for (int row = 0; row < grid.rows; ++row) {
          find_triangles(grid, heights, row, south);
          for (int column = 0; column < grid.columns; ++column) {
            const auto c = static_cast<std::size_t>(column);
            outline.triangles += south.lower[c] + south.upper[c];
            const int around = triangles_around(c, north, south);
            if (around > 0 && around < triangles_possible(grid, column, row))
              outline.vertices.push_back({column, row});
          }
          std::swap(north, south);
        }
      },
      grid.heights_m);
  return outline;
}

// Whether there is ground next to corner `a` in a, b, c (twice_area > 0): in all of the triangle,
// where no edge of the outline crosses it. REQUIRES a triangle within the grid.
bool has_ground(const Grid& grid, LatticePoint a, LatticePoint b, LatticePoint c) {
  // The grid's triangles around a vertex lie between each two of these directions.
  constexpr std::array<LatticePoint, 7> around{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, 0}}};
  const LatticePoint inward{(b.column - a.column) + (c.column - a.column),
                            (b.row - a.row) + (c.row - a.row)};
  const auto there = [&](LatticePoint step) {
    return !std::isnan(grid.height_m(a.column + step.column, a.row + step.row));
  };
  std::size_t i = 0;
  while (twice_area({}, around[i], inward) < 0 || twice_area({}, inward, around[i + 1]) < 0) ++i;
  return there({}) && there(around[i]) && there(around[i + 1]);
}

// The corners of the grid's rectangle, missing ones too, and the outline of its ground. Every edge
// of the outline is then an edge of the triangulation (lattice_triangulation.hpp, 2), so that each
// triangle has ground everywhere or nowhere, whatever is added later.
LatticeTriangulation outline_triangulation(const Grid& grid,
                                           const std::vector<LatticePoint>& outline) {
  LatticeTriangulation triangulation(grid.columns, grid.rows);
  const auto is_corner = [&](LatticePoint p) {
    return (p.column == 0 || p.column == grid.columns - 1) &&
           (p.row == 0 || p.row == grid.rows - 1);
  };
  std::uint32_t near = 0;
  for (const LatticePoint point : insertion_order(outline)) {
    if (is_corner(point)) continue;
    near = triangulation.find(point, near);
    triangulation.add(point, near);
  }
  return triangulation;
}

// Of one triangle: where it is farthest from the grid in height, and the grid's vertex to add.
struct Farthest {
  double distance_m = 0;
  LatticePoint add;
  bool operator==(const Farthest&) const = default;
};

struct Candidate {
  Farthest farthest;
  std::uint32_t triangle = 0;
};

// Whether `one` is to be added after `other`: the farther first, among equals the first of the
// grid.
struct IsAfter {
  bool operator()(const Candidate& one, const Candidate& other) const {
    const Farthest &a = one.farthest, &b = other.farthest;
    if (a.distance_m != b.distance_m) return a.distance_m < b.distance_m;
    return std::pair(a.add.row, a.add.column) > std::pair(b.add.row, b.add.column);
  }
};

// Adds vertices until the bound holds.
template <class Value>
class Refinement {
public:
  Refinement(const Grid& grid, const Heights<Value>& heights, double max_error_m,
             LatticeTriangulation& triangulation)
      : grid_(grid), heights_(heights), max_error_m_(max_error_m), triangulation_(triangulation),
        has_ground_(triangulation.triangles().size()), is_added_(grid.size()) {
    for (const LatticePoint point : triangulation.points()) is_added_[index(point)] = true;
    farthest_.resize(has_ground_.size());
    for (std::uint32_t t = 0; t < has_ground_.size(); ++t) {
      const auto& triangle = triangulation_.triangles()[t];
      has_ground_[t] =
          has_ground(grid, triangulation_.corner(triangle, 0), triangulation_.corner(triangle, 1),
                     triangulation_.corner(triangle, 2));
      if (has_ground_[t]) look_at(t);
    }
  }

  // By triangle, whether it has ground.
  std::vector<unsigned char> run() {
    while (!candidates_.empty()) {
      const Candidate next = candidates_.top();
      candidates_.pop();
      if (farthest_[next.triangle] != next.farthest) continue; // it has changed since
      if (!is_added_[index(next.farthest.add)]) add(next.farthest.add, next.triangle);
      // A vertex that cures a crossing may lie outside of the triangle and leave it as it was.
      if (farthest_[next.triangle] == next.farthest) look_at(next.triangle);
    }
    has_ground_.resize(triangulation_.triangles().size(), 1); // only ground is ever split
    return has_ground_;
  }

private:
  std::size_t index(LatticePoint p) const { return grid_.index(p.column, p.row); }

  void add(LatticePoint point, std::uint32_t near) {
    const auto& changed = triangulation_.add(point, triangulation_.find(point, near));
    is_added_[index(point)] = true;
    farthest_.resize(triangulation_.triangles().size());
    for (const std::uint32_t triangle : changed) look_at(triangle);
  }

  void look_at(std::uint32_t triangle) {
    farthest_[triangle] = farthest_of(triangulation_.triangles()[triangle]);
    if (farthest_[triangle].distance_m > max_error_m_)
      candidates_.push({farthest_[triangle], triangle});
  }

  Farthest farthest_of(const LatticeTriangulation::Triangle& triangle) const {
    std::array<LatticeCorner, 3> corners;
    for (int k = 0; k < 3; ++k) {
      const LatticePoint at = triangulation_.corner(triangle, k);
      corners[static_cast<std::size_t>(k)] = {at, static_cast<double>(heights_[index(at)])};
    }
    Farthest farthest;
    const LatticePlane plane(corners);
    plane.for_each_vertex([&](LatticePoint at, double height_m) {
      const double distance_m = std::abs(heights_[index(at)] - height_m);
      // At its corners rounding may leave a distance.
      if (distance_m > farthest.distance_m && !plane.is_corner(at)) farthest = {distance_m, at};
    });
    for (std::size_t k = 0; k < 3; ++k)
      LatticeEdge(corners[k], corners[(k + 1) % 3])
          .for_each_crossing([&](const GridCrossing& crossing) {
            const double crossing_m = distance_m(grid_, heights_, crossing);
            if (crossing_m > max_error_m_ && crossing_m > farthest.distance_m)
              farthest = {crossing_m, end_to_add(crossing)};
          });
    return farthest;
  }

  // The nearer end that isn't a vertex yet. One of them isn't, because the grid's edge would be one
  // of the triangulation if both were (lattice_triangulation.hpp, 2), and nothing would cross it.
  LatticePoint end_to_add(const GridCrossing& crossing) const {
    if (is_added_[index(crossing.first)]) return crossing.last;
    if (is_added_[index(crossing.last)]) return crossing.first;
    return crossing.share < 0.5 ? crossing.first : crossing.last;
  }

  const Grid& grid_;
  const Heights<Value>& heights_;
  const double max_error_m_;
  LatticeTriangulation& triangulation_;
  std::vector<unsigned char> has_ground_; // by triangle before the first was split
  std::vector<bool> is_added_;            // by vertex of the grid
  std::vector<Farthest> farthest_;        // by triangle, as it is now
  std::priority_queue<Candidate, std::vector<Candidate>, IsAfter> candidates_;
};

} // namespace

ApproximatedGrid approximate(const Grid& grid, double max_error_m) {
  const GridOutline outline = outline_of(grid);
  if (outline.triangles == 0)
    throw Error("the grid has no triangle", "at least three heights in one cell");
  if (max_error_m == 0) return {tin_of(grid), 0, 0};

  LatticeTriangulation triangulation = outline_triangulation(grid, outline.vertices);
  const auto ground = std::visit(
      [&](const auto& heights) {
        return Refinement(grid, heights, max_error_m, triangulation).run();
      },
      grid.heights_m);
  LatticeTin found = lattice_tin(grid, triangulation, ground);
  const double at_vertices_m = greatest_distance_at_vertices_m(grid, found.tin, found.at);
  const double at_crossings_m = greatest_distance_at_crossings_m(grid, found.tin, found.at);
  return {std::move(found.tin), at_vertices_m, std::max(at_vertices_m, at_crossings_m)};
}

} // namespace orograph
