// SPDX-License-Identifier: GPL-3.0-or-later
// Lines laid on a surface against the surface's heights at random places along them.
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/height_at.hpp"
#include "profiles/drape.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orograph::drape_test {
namespace {

// Where the surface counts `place`, on the ground.
Vec2 ground_of(const Surface& surface, Vec2 place) {
  const Grid* grid = std::get_if<Grid>(&surface);
  if (!grid) return place;
  const auto& [first_m, column_step_m, row_step_m] = grid->plane();
  return first_m + place.x * column_step_m + place.y * row_step_m;
}

bool is_between(double t, double a, double b) {
  return t >= std::min(a, b) && t <= std::max(a, b);
}

// The line's pieces are where the surface is, along all of it, and nowhere else.
void check(const Surface& surface, const std::vector<Vec2>& places, Random& random,
           std::size_t& asked, std::size_t& on_surface) {
  const View view = looking({0.6, 0.8}, {5, -7}, 2);
  Draper draper(surface, view);
  DrapedLine draped;
  draper.drape(places, 0, draped);
  // A place a billionth of a cell beside an edge may be on either side of it.
  constexpr double kRounding = 1e-7;
  for (const auto& [from, to, triangle] : draped.pieces) {
    REQUIRE(to == from + 1);
    const ProfilePoint at =
        point_between(draped.points[from], draped.points[to], random.between(0.01, 0.99));
    const Vec3 ground = to_ground_m(view, at);
    const auto height = height_at(surface, {ground.x, ground.y});
    REQUIRE(height.has_value());
    REQUIRE(std::abs(*height - ground.z) < kRounding);
  }
  bool all = true;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Vec2 from = ground_of(surface, places[i]), way = ground_of(surface, places[i + 1]) - from;
    for (int k = 0; k < 20; ++k) {
      const double t = random.between(0, 1);
      const Vec2 at = from + t * way;
      const auto height = height_at(surface, at);
      std::size_t covering = 0;
      for (const auto& [first, last, triangle] : draped.pieces) {
        const Vec3 a = to_ground_m(view, draped.points[first]),
                   b = to_ground_m(view, draped.points[last]);
        const Vec2 pa = Vec2{a.x, a.y} - from, pb = Vec2{b.x, b.y} - from;
        const double length2 = dot(way, way);
        const bool is_along = std::abs(cross(pa, way)) < kRounding * std::sqrt(length2) &&
                              std::abs(cross(pb, way)) < kRounding * std::sqrt(length2);
        if (is_along && is_between(t, dot(pa, way) / length2, dot(pb, way) / length2)) ++covering;
      }
      ++asked;
      on_surface += height ? 1 : 0;
      all = all && height;
      if (height)
        REQUIRE(covering >= 1);
      else
        REQUIRE(covering == 0);
    }
  }
  if (draped.is_whole) CHECK(all);
  if (!all) CHECK_FALSE(draped.is_whole);
}

} // namespace

TEST_CASE("a draped line is on the surface wherever there is one under it") {
  std::size_t asked = 0, on_surface = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    GridLattice lattice{random.whole(2, 14), random.whole(2, 14)};
    lattice.column_step_m = {random.between(0.5, 1.3), random.between(-0.2, 0.2)};
    lattice.row_step_m = {random.between(-0.2, 0.2), random.between(-1.3, -0.5)};
    const Grid grid =
        made_grid(random, lattice, {.low = 0, .high = 9, .missing = seed % 3 ? 0 : 0.1});
    // From beside the terrain to beside it; whole places are vertices, and lines along edges.
    const auto place = [&] {
      const Vec2 at{random.between(-2, grid.columns + 1), random.between(-2, grid.rows + 1)};
      return seed % 4 ? at : Vec2{std::round(at.x), std::round(at.y)};
    };
    std::vector<Vec2> places;
    for (int i = random.whole(2, 5); i > 0; --i) places.push_back(place());
    if (seed % 4) check(grid, places, random, asked, on_surface);
    bool has_triangle = false;
    for (int r = 0; r + 1 < grid.rows; ++r)
      for (int c = 0; c + 1 < grid.columns; ++c)
        has_triangle |= !std::isnan(grid.height_m(c, r) + grid.height_m(c + 1, r + 1) +
                                    grid.height_m(c + 1, r));
    if (!has_triangle || seed % 4 == 0) continue;
    std::vector<Vec2> on_ground;
    for (const Vec2 at : places) on_ground.push_back(ground_of(grid, at));
    check(tin_of(grid), on_ground, random, asked, on_surface);
  }
  WARN(asked << " places, " << on_surface << " on the surface");
  CHECK(on_surface > enough(5000));
  CHECK(asked - on_surface > enough(2000));
}

TEST_CASE("a draped line along the lattice goes through vertices, and stays in one piece") {
  Random random(7);
  const Grid grid = made_grid(random, {6, 6}, {.low = 0, .high = 9});
  const Surface surface = grid;
  const View view = looking({0, 1});
  Draper draper(surface, view);
  DrapedLine draped;
  for (const std::vector<Vec2>& places :
       {std::vector<Vec2>{{1, 2}, {4, 2}}, {{3, 0}, {3, 5}}, {{0, 0}, {5, 5}}, {{4, 4}, {1, 1}}}) {
    draper.drape(places, 0.5, draped);
    REQUIRE(draped.is_whole);
    const std::size_t steps = static_cast<std::size_t>(
        std::max(std::abs(places[1].x - places[0].x), std::abs(places[1].y - places[0].y)));
    REQUIRE(draped.points.size() == steps + 1);
    for (std::size_t i = 0; i <= steps; ++i) {
      const Vec2 at = places[0] + (static_cast<double>(i) / static_cast<double>(steps)) *
                                      (places[1] - places[0]);
      const double height =
          grid.height_m(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y)));
      CHECK(std::abs(draped.points[i].z - (height + 0.5)) < 1e-12);
    }
  }
}

} // namespace orograph::drape_test
