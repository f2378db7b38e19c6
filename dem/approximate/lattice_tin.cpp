// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/approximate/lattice_tin.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace orograph {
namespace {

using Numbers = std::vector<std::uint32_t>;

// The triangulation's vertices that wanted triangles use, in row-major order.
Numbers used_vertices(const LatticeTriangulation& triangulation,
                      const std::vector<unsigned char>& wanted) {
  const auto& points = triangulation.points();
  std::vector<unsigned char> used(points.size());
  for (std::size_t t = 0; t < wanted.size(); ++t)
    if (wanted[t])
      for (const std::uint32_t v : triangulation.triangles()[t].vertices) used[v] = 1;
  Numbers vertices;
  for (std::uint32_t v = 0; v < points.size(); ++v)
    if (used[v]) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end(), [&](std::uint32_t one, std::uint32_t other) {
    const LatticePoint a = points[one], b = points[other];
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  });
  return vertices;
}

struct NumberedTriangle {
  std::array<std::uint32_t, 3> vertices, neighbours; // as the triangulation numbers triangles
  std::uint32_t number;                              // there
};

NumberedTriangle turned_over(NumberedTriangle triangle) {
  std::swap(triangle.vertices[1], triangle.vertices[2]);
  std::swap(triangle.neighbours[1], triangle.neighbours[2]);
  return triangle;
}

NumberedTriangle from_lowest(NumberedTriangle triangle) {
  const auto lowest = std::min_element(triangle.vertices.begin(), triangle.vertices.end()) -
                      triangle.vertices.begin();
  std::rotate(triangle.vertices.begin(), triangle.vertices.begin() + lowest,
              triangle.vertices.end());
  std::rotate(triangle.neighbours.begin(), triangle.neighbours.begin() + lowest,
              triangle.neighbours.end());
  return triangle;
}

} // namespace

LatticeTin lattice_tin(const Grid& grid, const LatticeTriangulation& triangulation,
                       const std::vector<unsigned char>& wanted) {
  LatticeTin result;
  Numbers number_of(triangulation.points().size(), 0);
  for (const std::uint32_t v : used_vertices(triangulation, wanted)) {
    const LatticePoint at = triangulation.points()[v];
    number_of[v] = static_cast<std::uint32_t>(result.at.size());
    result.at.push_back(at);
    result.tin.vertices_m.push_back(grid.vertex_m(at.column, at.row));
  }

  // Columns and rows run counterclockwise with y up; on the ground rows usually go south.
  const bool turned = grid.is_on_earth() || !grid.plane().is_mirrored();
  std::vector<NumberedTriangle> triangles;
  for (std::uint32_t t = 0; t < wanted.size(); ++t) {
    if (!wanted[t]) continue;
    const auto& from = triangulation.triangles()[t];
    NumberedTriangle triangle{from.vertices, from.neighbours, t};
    for (std::uint32_t& v : triangle.vertices) v = number_of[v];
    triangles.push_back(from_lowest(turned ? turned_over(triangle) : triangle));
  }
  std::sort(triangles.begin(), triangles.end(),
            [](const auto& one, const auto& other) { return one.vertices < other.vertices; });

  Numbers new_number(wanted.size(), kNoTriangle);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) new_number[triangles[t].number] = t;
  for (const NumberedTriangle& triangle : triangles) {
    result.tin.triangles.push_back(triangle.vertices);
    auto& neighbours = result.tin.neighbours.emplace_back(triangle.neighbours);
    for (std::uint32_t& n : neighbours)
      n = n == LatticeTriangulation::kNone ? kNoTriangle : new_number[n];
  }
  return result;
}

} // namespace orograph
