// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/surface_distance.hpp"

#include "dem/lattice_plane.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace orograph {
namespace {

// The grid's three families of parallel edges. Each line of one has a number, and each vertex on it
// a place, one from the next.
enum class Family { columns, rows, diagonals };

struct LinePlace {
  int line, place;
};

LinePlace on_lines(Family family, LatticePoint p) {
  if (family == Family::columns) return {p.column, p.row};
  if (family == Family::rows) return {p.row, p.column};
  return {p.column - p.row, p.row};
}

LatticePoint vertex_at(Family family, LinePlace at) {
  if (family == Family::columns) return {at.line, at.place};
  if (family == Family::rows) return {at.place, at.line};
  return {at.line + at.place, at.place};
}

// An edge of the Tin against all lines of a family that it crosses. Where, in whole numbers.
template <class Value>
double greatest_on_edge(const Grid& grid, const std::vector<Value>& heights, LatticePoint from,
                        LatticePoint to, Family family) {
  const auto height_m = [&](LatticePoint p) {
    return static_cast<double>(heights[grid.index(p.column, p.row)]);
  };
  const LinePlace begin = on_lines(family, from), end = on_lines(family, to);
  const int step = end.line < begin.line ? -1 : 1, lines = std::abs(end.line - begin.line);
  const double from_m = height_m(from), rise_m = height_m(to) - from_m;
  double greatest = 0;
  for (int i = 1; i < lines; ++i) {
    const std::int64_t run = std::int64_t{i} * (end.place - begin.place);
    int place = begin.place + static_cast<int>(run / lines), rest = static_cast<int>(run % lines);
    if (rest == 0) continue; // at a vertex
    if (rest < 0) {
      --place;
      rest += lines;
    }
    const int line = begin.line + i * step;
    const double low_m = height_m(vertex_at(family, {line, place}));
    const double high_m = height_m(vertex_at(family, {line, place + 1}));
    const double of_grid = low_m + static_cast<double>(rest) / lines * (high_m - low_m);
    const double of_tin = from_m + static_cast<double>(i) / lines * rise_m;
    greatest = std::max(greatest, std::abs(of_grid - of_tin));
  }
  return greatest;
}

} // namespace

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
        for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
          for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t across = tin.neighbours[t][k];
            if (across < t) continue; // each edge once; kNoTriangle is the greatest number
            const std::uint32_t one = tin.triangles[t][(k + 1) % 3];
            const std::uint32_t other = tin.triangles[t][(k + 2) % 3];
            for (const Family family : {Family::columns, Family::rows, Family::diagonals})
              greatest =
                  std::max(greatest, greatest_on_edge(grid, heights, at[std::min(one, other)],
                                                      at[std::max(one, other)], family));
          }
      },
      grid.heights_m);
  return greatest;
}

} // namespace orograph
