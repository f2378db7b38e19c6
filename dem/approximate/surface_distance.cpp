// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/approximate/surface_distance.hpp"

#include "dem/approximate/lattice_edge.hpp"
#include "dem/approximate/lattice_plane.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace orograph {
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
