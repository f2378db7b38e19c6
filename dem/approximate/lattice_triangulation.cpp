// SPDX-License-Identifier: GPL-3.0-or-later
// Lawson's insertion: split the triangle that holds the vertex, then flip edges opposite to it.
#include "dem/approximate/lattice_triangulation.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

namespace orograph {
namespace {

__extension__ using Wide = __int128; // differences below 2^30 make determinants below 2^124

struct Offset {
  std::int64_t x, y;
};

Offset offset(LatticePoint from, LatticePoint to) {
  return {to.column - from.column, to.row - from.row};
}

template <class Lift>
Wide lifted_volume(Offset a, Offset b, Offset c, Lift lift) {
  const auto turn = [](Offset p, Offset q) { return p.x * q.y - p.y * q.x; };
  return Wide{lift(a)} * turn(b, c) + Wide{lift(b)} * turn(c, a) + Wide{lift(c)} * turn(a, b);
}

// Whether p lies inside the circle of a, b, c (counterclockwise). Of x^2 + y^2 - e x y, the small
// part decides where the large one says "on it".
bool in_circle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint p) {
  const Offset pa = offset(p, a), pb = offset(p, b), pc = offset(p, c);
  const Wide round = lifted_volume(pa, pb, pc, [](Offset v) { return v.x * v.x + v.y * v.y; });
  if (round != 0) return round > 0;
  return lifted_volume(pa, pb, pc, [](Offset v) { return -v.x * v.y; }) > 0;
}

std::uint64_t spread(std::uint32_t bits) { // a zero before each bit
  std::uint64_t x = bits;
  x = (x | x << 16) & 0x0000ffff0000ffff;
  x = (x | x << 8) & 0x00ff00ff00ff00ff;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0f;
  x = (x | x << 2) & 0x3333333333333333;
  x = (x | x << 1) & 0x5555555555555555;
  return x;
}

// Along the Z-shaped curve.
std::uint64_t place_on_curve(LatticePoint point) {
  return spread(static_cast<std::uint32_t>(point.column)) |
         spread(static_cast<std::uint32_t>(point.row)) << 1;
}

// The more zeros a number without pattern ends in, the earlier.
int round_before_last(std::uint64_t place) {
  place = (place ^ place >> 31) * 0x9e3779b97f4a7c15;
  place = (place ^ place >> 29) * 0xbf58476d1ce4e5b9;
  return std::countr_zero((place ^ place >> 32) | std::uint64_t{1} << 40);
}

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

LatticeTriangulation::LatticeTriangulation(int columns, int rows)
    : points_{{0, 0}, {columns - 1, 0}, {columns - 1, rows - 1}, {0, rows - 1}},
      triangles_{{{0, 1, 2}, {kNone, 1, kNone}}, {{0, 2, 3}, {kNone, kNone, 0}}} {}

std::uint32_t LatticeTriangulation::find(LatticePoint point, std::uint32_t near) const {
  // Always across an edge that has the point on its other side: in a Delaunay triangulation that
  // comes to an end.
  for (std::uint32_t at = near;;) {
    const Triangle& triangle = triangles_[at];
    std::uint32_t next = at;
    for (int k = 0; k < 3 && next == at; ++k)
      if (twice_area(corner(triangle, (k + 1) % 3), corner(triangle, (k + 2) % 3), point) < 0)
        next = triangle.neighbours[static_cast<std::size_t>(k)];
    if (next == at) return at;
    at = next;
  }
}

const std::vector<std::uint32_t>& LatticeTriangulation::add(LatticePoint point,
                                                            std::uint32_t holder) {
  const auto vertex = static_cast<std::uint32_t>(points_.size());
  points_.push_back(point);
  changed_.clear();
  to_check_.clear();
  int edge = -1; // that the point lies on
  const Triangle& triangle = triangles_[holder];
  for (int k = 0; k < 3; ++k)
    if (twice_area(corner(triangle, (k + 1) % 3), corner(triangle, (k + 2) % 3), point) == 0)
      edge = k;
  if (edge < 0)
    split_inside(vertex, holder);
  else
    split_edge(vertex, holder, edge);
  flip_until_delaunay();
  return changed_;
}

std::uint32_t LatticeTriangulation::add_triangle(const Triangle& triangle) {
  triangles_.push_back(triangle);
  return static_cast<std::uint32_t>(triangles_.size() - 1);
}

void LatticeTriangulation::replace_neighbour(std::uint32_t of, std::uint32_t old,
                                             std::uint32_t by) {
  if (of == kNone) return;
  for (std::uint32_t& neighbour : triangles_[of].neighbours)
    if (neighbour == old) neighbour = by;
}

// The new vertex is the last one of every triangle made here, so that the edge to check is
// opposite to it: number 2.
void LatticeTriangulation::split_inside(std::uint32_t vertex, std::uint32_t holder) {
  const auto [a, b, c] = triangles_[holder].vertices;
  const auto [beyond_a, beyond_b, beyond_c] = triangles_[holder].neighbours;
  const std::uint32_t second = add_triangle({{b, c, vertex}, {kNone, holder, beyond_a}});
  const std::uint32_t third = add_triangle({{c, a, vertex}, {holder, second, beyond_b}});
  triangles_[second].neighbours[0] = third;
  triangles_[holder] = {{a, b, vertex}, {second, third, beyond_c}};
  replace_neighbour(beyond_a, holder, second);
  replace_neighbour(beyond_b, holder, third);
  changed_ = {holder, second, third};
  to_check_ = changed_;
}

void LatticeTriangulation::split_edge(std::uint32_t vertex, std::uint32_t holder, int edge) {
  const auto k = static_cast<std::size_t>(edge), k1 = (k + 1) % 3, k2 = (k + 2) % 3;
  const Triangle before = triangles_[holder];
  const std::uint32_t c = before.vertices[k], a = before.vertices[k1], b = before.vertices[k2];
  const std::uint32_t across = before.neighbours[k];
  const std::uint32_t beyond_a = before.neighbours[k1], beyond_b = before.neighbours[k2];

  // c over the edge from a to b: (c, a, vertex) stays in its place, (b, c, vertex) is new.
  const std::uint32_t second = add_triangle({{b, c, vertex}, {holder, kNone, beyond_a}});
  triangles_[holder] = {{c, a, vertex}, {kNone, second, beyond_b}};
  replace_neighbour(beyond_a, holder, second);
  changed_ = {holder, second};
  if (across != kNone) {
    const Triangle other = triangles_[across];
    std::size_t j = 0;
    while (other.neighbours[j] != holder) ++j;
    const std::uint32_t d = other.vertices[j];                  // runs d, b, a
    const std::uint32_t over_b = other.neighbours[(j + 1) % 3]; // across a, d
    const std::uint32_t over_a = other.neighbours[(j + 2) % 3]; // across d, b
    const std::uint32_t fourth = add_triangle({{d, b, vertex}, {second, across, over_a}});
    triangles_[across] = {{a, d, vertex}, {fourth, holder, over_b}};
    replace_neighbour(over_a, across, fourth);
    triangles_[holder].neighbours[0] = across;
    triangles_[second].neighbours[1] = fourth;
    changed_.push_back(across);
    changed_.push_back(fourth);
  }
  to_check_ = changed_;
}

void LatticeTriangulation::flip_until_delaunay() {
  while (!to_check_.empty()) {
    const std::uint32_t one = to_check_.back();
    const auto [a, b, vertex] = triangles_[one].vertices;
    const auto [beyond_a, beyond_b, other] = triangles_[one].neighbours;
    std::size_t j = 0;
    if (other != kNone)
      while (triangles_[other].neighbours[j] != one) ++j;
    if (other == kNone || !in_circle(points_[a], points_[b], points_[vertex],
                                     points_[triangles_[other].vertices[j]])) {
      to_check_.pop_back();
      continue;
    }
    // The edge from a to b becomes one from d to the new vertex.
    const std::uint32_t d = triangles_[other].vertices[j];                  // `other` runs d, b, a
    const std::uint32_t over_b = triangles_[other].neighbours[(j + 1) % 3]; // across a, d
    const std::uint32_t over_a = triangles_[other].neighbours[(j + 2) % 3]; // across d, b
    triangles_[one] = {{a, d, vertex}, {other, beyond_b, over_b}};
    triangles_[other] = {{d, b, vertex}, {beyond_a, one, over_a}};
    replace_neighbour(beyond_a, one, other);
    replace_neighbour(over_b, other, one);
    changed_.push_back(other);
    to_check_.push_back(other);
  }
}

std::vector<LatticePoint> insertion_order(const std::vector<LatticePoint>& points) {
  struct Key {
    int before_last;
    std::uint64_t place;
    LatticePoint point;
  };
  std::vector<Key> keys;
  keys.reserve(points.size());
  for (const LatticePoint& point : points) {
    const std::uint64_t place = place_on_curve(point);
    keys.push_back({round_before_last(place), place, point});
  }
  std::sort(keys.begin(), keys.end(), [](const Key& one, const Key& other) {
    return one.before_last != other.before_last ? one.before_last > other.before_last
                                                : one.place < other.place;
  });
  std::vector<LatticePoint> ordered;
  ordered.reserve(keys.size());
  for (const Key& key : keys) ordered.push_back(key.point);
  return ordered;
}

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

double greatest_distance_at_vertices_m(const Grid& grid, const Tin& tin,
                                       const std::vector<LatticePoint>& at) {
  double greatest = 0;
  std::visit(
      [&](const auto& heights) {
        for (std::size_t v = 0; v < at.size(); ++v) {
          const auto height_m = static_cast<double>(heights[grid.index(at[v].column, at[v].row)]);
          greatest = std::max(greatest, std::abs(height_m - tin.vertices_m[v].z));
        }
        for (const auto& [a, b, c] : tin.triangles) {
          const auto corner = [&](std::uint32_t v) {
            return LatticeCorner{at[v], tin.vertices_m[v].z};
          };
          const LatticePlane plane({corner(a), corner(b), corner(c)});
          plane.for_each_vertex([&](LatticePoint p, double height_m) {
            const double distance_m = std::abs(heights[grid.index(p.column, p.row)] - height_m);
            if (distance_m > greatest && !plane.is_corner(p)) greatest = distance_m;
          });
        }
      },
      grid.heights_m);
  return greatest;
}

double greatest_distance_at_crossings_m(const Grid& grid, const Tin& tin,
                                        const std::vector<LatticePoint>& at) {
  double greatest = 0;
  std::visit(
      [&](const auto& heights) {
        const auto end = [&](std::uint32_t v) { return LatticeCorner{at[v], tin.vertices_m[v].z}; };
        for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
          for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t across = tin.neighbours[t][k];
            if (across < t) continue; // each edge once; kNoTriangle is the greatest number
            const LatticeEdge edge(end(tin.triangles[t][(k + 1) % 3]),
                                   end(tin.triangles[t][(k + 2) % 3]));
            edge.for_each_crossing([&](const GridCrossing& crossing) {
              greatest = std::max(greatest, distance_m(grid, heights, crossing));
            });
          }
      },
      grid.heights_m);
  return greatest;
}

} // namespace orograph
