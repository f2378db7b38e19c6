// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/approximate_grid.hpp"

#include "dem/grid_ground.hpp"
#include "dem/insertion_order.hpp"
#include "dem/lattice_plane.hpp"
#include "dem/lattice_tin.hpp"
#include "dem/lattice_triangulation.hpp"
#include "dem/surface_distance.hpp"
#include "geometry/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <vector>

namespace orograph {
namespace {

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

// Of one triangle: the grid's vertex that is farthest from it in height.
struct Farthest {
  double distance_m = 0;
  LatticePoint at;
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
    return a.at.row != b.at.row ? a.at.row > b.at.row : a.at.column > b.at.column;
  }
};

template <class Value>
Farthest farthest_vertex(const Grid& grid, const std::vector<Value>& heights,
                         const LatticeTriangulation& triangulation, std::uint32_t number) {
  const auto& triangle = triangulation.triangles()[number];
  const auto corner = [&](int k) {
    const LatticePoint at = triangulation.corner(triangle, k);
    return LatticeCorner{at, static_cast<double>(heights[grid.index(at.column, at.row)])};
  };
  const LatticePlane plane({corner(0), corner(1), corner(2)});
  Farthest farthest;
  plane.for_each_vertex([&](LatticePoint at, double height_m) {
    const double distance_m = std::abs(heights[grid.index(at.column, at.row)] - height_m);
    // At its corners rounding may leave a distance.
    if (distance_m > farthest.distance_m && !plane.is_corner(at)) farthest = {distance_m, at};
  });
  return farthest;
}

// Adds vertices until all are within the bound, and gives the triangles that have ground.
template <class Value>
std::vector<unsigned char> refine(const Grid& grid, const std::vector<Value>& heights,
                                  double max_error_m, LatticeTriangulation& triangulation) {
  std::vector<Farthest> farthest; // by triangle, as it is now
  std::priority_queue<Candidate, std::vector<Candidate>, IsAfter> candidates;
  const auto look = [&](std::uint32_t triangle) {
    farthest[triangle] = farthest_vertex(grid, heights, triangulation, triangle);
    if (farthest[triangle].distance_m > max_error_m)
      candidates.push({farthest[triangle], triangle});
  };

  std::vector<unsigned char> ground(triangulation.triangles().size());
  farthest.resize(ground.size());
  for (std::uint32_t t = 0; t < ground.size(); ++t) {
    const auto& triangle = triangulation.triangles()[t];
    ground[t] = has_ground(grid, triangulation.corner(triangle, 0),
                           triangulation.corner(triangle, 1), triangulation.corner(triangle, 2));
    if (ground[t]) look(t);
  }
  while (!candidates.empty()) {
    const Candidate next = candidates.top();
    candidates.pop();
    if (farthest[next.triangle] != next.farthest) continue; // it has changed since
    const auto& changed = triangulation.add(next.farthest.at, next.triangle);
    farthest.resize(triangulation.triangles().size());
    for (const std::uint32_t triangle : changed) look(triangle);
  }
  ground.resize(triangulation.triangles().size(), 1); // only ground is ever split
  return ground;
}

} // namespace

ApproximatedGrid approximate(const Grid& grid, double max_error_m) {
  const GridOutline outline = outline_of(grid);
  if (outline.triangles == 0)
    throw Error("the grid has no triangle", "at least three heights in one cell");
  if (max_error_m == 0) return {tin_of(grid), 0, 0};

  LatticeTriangulation triangulation = outline_triangulation(grid, outline.vertices);
  const auto ground = std::visit(
      [&](const auto& heights) { return refine(grid, heights, max_error_m, triangulation); },
      grid.heights_m);
  LatticeTin found = lattice_tin(grid, triangulation, ground);
  const double at_vertices_m = greatest_distance_at_vertices_m(grid, found.tin, found.at);
  const double at_crossings_m = greatest_distance_at_crossings_m(grid, found.tin, found.at);
  return {std::move(found.tin), at_vertices_m, std::max(at_vertices_m, at_crossings_m)};
}

} // namespace orograph
