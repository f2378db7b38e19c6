// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on the water against distances from every vertex to every shore.
#include "dem/approximate/tin_of_grid.hpp"
#include "profiles/level_ground.hpp"
#include "profiles/waterlines.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace orograph::waterlines_test {
namespace {

constexpr std::array<double, 4> kDistances_m{0.8, 1, 2.5, 5.0};

// Samples a segment ever more finely about its nearest point, instead of projecting on it.
double distance_m(Vec3 p, Vec3 from, Vec3 to) {
  const auto at = [&](double t) { return length(from + t * (to - from) - p); };
  double low = 0, high = 1;
  for (int i = 0; i < 100; ++i) {
    const double third = (high - low) / 3;
    (at(low + third) > at(high - third) ? low : high) =
        at(low + third) > at(high - third) ? low + third : high - third;
  }
  return at(0.5 * (low + high));
}

// All of it by definition: crossings of the edges of level triangles, and lines between them.
void check(const Surface& surface, const LevelGround& level,
           const std::vector<std::array<std::uint32_t, 3>>& triangles,
           const std::vector<Vec3>& vertices, std::size_t& lines) {
  const Isolines found = waterlines(surface, level, kDistances_m);
  std::vector<double> distance(vertices.size(), INFINITY);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (const SurfaceEdge& shore : level.shores)
      distance[i] =
          std::min(distance[i], distance_m(vertices[i], vertices[shore.from], vertices[shore.to]));

  constexpr double kRounding = 1e-7, kOffVertex = 1.1e-6;
  std::vector<double> of_points;
  for (const EdgePoint& point : found.points) {
    const double from = distance[point.edge.from], to = distance[point.edge.to];
    const double at = std::min(from, 10.0) + point.t * (std::min(to, 10.0) - std::min(from, 10.0));
    const auto asked = std::ranges::find_if(kDistances_m, [&](double d) {
      return std::abs(at - d) <= kRounding + kOffVertex * std::abs(to - from);
    });
    REQUIRE(asked != kDistances_m.end());
    of_points.push_back(*asked);
  }
  using Place = std::pair<double, SurfaceEdge>;
  std::multiset<std::pair<Place, Place>> drawn, wanted;
  for (const Isoline& line : found.lines) {
    if (line.from < vertices.size()) return; // a vertex is on a line, to rounding
    const std::size_t a = line.from - vertices.size(), b = line.to - vertices.size();
    REQUIRE(of_points[a] == of_points[b]);
    drawn.insert(std::minmax(Place{of_points[a], found.points[a].edge},
                             Place{of_points[b], found.points[b].edge}));
  }
  bool is_close = false; // a vertex is so near to a line that rounding decides
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!level.triangles.has(t)) continue;
    for (const double d : kDistances_m) {
      std::vector<Place> crossed;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [a, b] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
        is_close |= std::abs(distance[a] - d) < kRounding;
        if ((distance[a] >= d) != (distance[b] >= d)) crossed.push_back({d, {a, b}});
      }
      if (crossed.size() == 2) wanted.insert(std::minmax(crossed[0], crossed[1]));
    }
  }
  if (is_close) return;
  CHECK(drawn == wanted);
  lines += drawn.size();
}

} // namespace

TEST_CASE("lines on the water are where the distance to the nearest shore is as asked",
          "[unsanitized]") {
  std::size_t lines = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(24); ++seed) {
    Random random(seed);
    GridLattice lattice{random.whole(8, 24), random.whole(8, 24)};
    lattice.column_step_m = {random.between(0.5, 1.3), random.between(-0.2, 0.2)};
    lattice.row_step_m = {random.between(-0.2, 0.2), random.between(-1.3, -0.5)};
    Grid grid = made_grid(random, lattice, {.low = -50, .high = 3, .missing = seed % 3 ? 0 : 0.05});
    const auto heights = std::get<Heights<float>>(grid.heights_m).own();
    for (float& h : heights) h = std::isnan(h) ? h : std::max(h, 0.0F);
    INFO("seed " << seed);
    {
      const LevelGround level = find_level_ground(grid, 4);
      std::vector<std::array<std::uint32_t, 3>> triangles(grid_triangle_count(grid));
      std::vector<Vec3> vertices;
      for (std::size_t i = 0; i < grid.size(); ++i) vertices.push_back(grid.vertex_m(i));
      for (int r = 0; r + 1 < grid.rows; ++r)
        for (int c = 0; c + 1 < grid.columns; ++c) {
          const auto at = [&](int x, int y) {
            return static_cast<std::uint32_t>(grid.index(x, y));
          };
          triangles[grid_triangle(grid, c, r, Half::lower)] = {at(c, r), at(c, r + 1),
                                                               at(c + 1, r + 1)};
          triangles[grid_triangle(grid, c, r, Half::upper)] = {at(c, r), at(c + 1, r + 1),
                                                               at(c + 1, r)};
        }
      check(grid, level, triangles, vertices, lines);
    }
    const Tin tin = tin_of(grid);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& corners : tin.triangles)
      triangles.push_back({corners[0], corners[1], corners[2]});
    check(tin, find_level_ground(tin, 2), triangles, {tin.vertices_m.begin(), tin.vertices_m.end()},
          lines);
  }
  WARN(lines << " lines");
  CHECK(lines > enough(800));
}

TEST_CASE("without shores, or distances, there are no lines on the water") {
  Random random(1);
  const Grid level = made_grid(random, {12, 12}, {.low = 3, .high = 3});
  CHECK(waterlines(level, find_level_ground(level, 4), kDistances_m).lines.empty());
  CHECK(waterlines(level, find_level_ground(level, 4), {}).lines.empty());
}

} // namespace orograph::waterlines_test
