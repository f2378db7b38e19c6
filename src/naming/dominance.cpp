// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/dominance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace orograph {
namespace {

// At a vertex: to the next column and to the next row.
struct Steps {
  Vec2 column_m, row_m;
};

Steps steps_at(const Grid& grid, int column, int row) {
  const int right = column + 1 < grid.columns ? 1 : -1, down = row + 1 < grid.rows ? 1 : -1;
  return std::visit(
      [&](const auto& lattice) {
        const Vec3 here = lattice.vertex_m(column, row, 0),
                   beside = lattice.vertex_m(column + right, row, 0),
                   below = lattice.vertex_m(column, row + down, 0);
        return Steps{right * Vec2{beside.x - here.x, beside.y - here.y},
                     down * Vec2{below.x - here.x, below.y - here.y}};
      },
      grid.lattice);
}

// What a line meets in a triangle: from one distance along it to another, and the heights there.
struct Section {
  double from_m, to_m, from_z_m, to_z_m;
};

void add_section(const Tin& tin, std::uint32_t triangle, Vec2 start, Vec2 way,
                 std::vector<Section>& out) {
  Section section{1, 0, 0, 0};
  const auto take = [&](double at_m, double z_m) {
    const bool is_first = section.from_m > section.to_m;
    if (is_first || at_m < section.from_m)
      std::tie(section.from_m, section.from_z_m) = std::pair(at_m, z_m);
    if (is_first || at_m > section.to_m)
      std::tie(section.to_m, section.to_z_m) = std::pair(at_m, z_m);
  };
  std::array<double, 3> along{}, aside{}, z{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& corner = tin.vertices_m[tin.triangles[triangle][k]];
    const Vec2 from_start = Vec2{corner.x, corner.y} - start;
    along[k] = dot(from_start, way);
    aside[k] = cross(way, from_start);
    z[k] = corner.z;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (aside[k] == 0) take(along[k], z[k]);
    if ((aside[k] < 0) == (aside[next] < 0) || aside[k] == 0 || aside[next] == 0) continue;
    const double share = aside[k] / (aside[k] - aside[next]);
    take(along[k] + share * (along[next] - along[k]), z[k] + share * (z[next] - z[k]));
  }
  if (section.to_m > std::max(section.from_m, 0.0)) out.push_back(section);
}

} // namespace

double dominance_m(const Grid& grid, std::uint32_t vertex, Vec2 across) {
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const int column = static_cast<int>(vertex % columns), row = static_cast<int>(vertex / columns);
  const auto [column_m, row_m] = steps_at(grid, column, row);
  const double area = cross(column_m, row_m);
  const double cell_m = std::min(length(column_m), length(row_m));
  if (!(cell_m > 0) || area == 0) return 0;
  const Vec2 step{cell_m * cross(across, row_m) / area, cell_m * cross(column_m, across) / area};
  const int count = static_cast<int>(kDominanceReach_m / cell_m);
  const double own_m = grid.height_m(column, row);
  const auto low_m = [&](double side) {
    double lowest = own_m;
    for (int i = 1; i <= count; ++i) {
      const double c = std::round(column + side * i * step.x),
                   r = std::round(row + side * i * step.y);
      if (!(c >= 0 && r >= 0 && c < grid.columns && r < grid.rows)) break;
      const double height_m = grid.height_m(static_cast<int>(c), static_cast<int>(r));
      if (!(height_m <= own_m)) break; // higher, or none
      lowest = std::min(lowest, height_m);
    }
    return lowest;
  };
  return own_m - std::max(low_m(-1), low_m(1));
}

double dominance_m(const Tin& tin, const TinIndex& index, std::uint32_t vertex, Vec2 across) {
  const Vec2 start = plan_m(tin, vertex);
  const double own_m = tin.vertices_m[vertex].z;
  std::vector<std::uint32_t> triangles;
  std::vector<Section> sections;
  const auto low_m = [&](double side) {
    const Vec2 way = side * across;
    index.along(start, start + kDominanceReach_m * way, 0, triangles);
    sections.clear();
    for (const std::uint32_t triangle : triangles) add_section(tin, triangle, start, way, sections);
    std::ranges::sort(sections, {}, &Section::from_m);
    constexpr double kRounding_m = 1e-6;
    double lowest = own_m, reached_m = 0;
    for (const auto& [from_m, to_m, from_z_m, to_z_m] : sections) {
      if (from_m > std::min(reached_m + kRounding_m, kDominanceReach_m)) break; // nothing, or far
      if (from_z_m > own_m + kRounding_m) break;
      lowest = std::min(lowest, from_z_m);
      if (to_z_m > own_m + kRounding_m) break;
      lowest = std::min(lowest, to_z_m);
      reached_m = std::max(reached_m, to_m);
    }
    return lowest;
  };
  return own_m - std::max(low_m(-1), low_m(1));
}

} // namespace orograph
