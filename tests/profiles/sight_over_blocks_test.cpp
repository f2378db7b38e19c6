// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that may stand high enough tell what a walk over all ground tells.
#include "dem/extent.hpp"
#include "profiles/outline.hpp"
#include "profiles/sight_over_blocks.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/asked_of_seeds.hpp"
#include "tests/support/made_earth_grid.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace orograph::sight_over_blocks_test {
namespace {

struct Sums {
  std::uint64_t seed = 0;
  int asked = 0, told = 0, higher = 0, lower = 0, on_ground = 0;
};

// Peaks over a plain, with stones on it, and gaps.
void raise_mountains(Random& random, Grid& grid, double high_m) {
  struct Peak {
    int column, row;
    double high_m, wide;
  };
  std::vector<Peak> peaks;
  for (int i = random.whole(0, 12); i > 0; --i)
    peaks.push_back({random.whole(0, grid.columns - 1), random.whole(0, grid.rows - 1),
                     high_m * random.share(), random.between(2, 40)});
  const double stone_m = random.pick({0.0, 1e-3, 1e-2}) * high_m;
  std::vector<double> heights;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      double height_m = stone_m * random.share();
      for (const Peak& peak : peaks)
        height_m += std::max(
            0.0, peak.high_m * (1 - std::hypot(column - peak.column, row - peak.row) / peak.wide));
      heights.push_back(height_m);
    }
  if (random.chance(0.4)) make_gaps(random, grid.columns, grid.rows, heights);
  grid.heights_m = std::move(heights);
}

void check(const Grid& grid, const View& view, Random& random, Sums& sums) {
  const Surface surface = grid;
  const std::vector<BorderEdge> border = border_edges(grid, false);
  const SightLines lines(surface, border, view);
  const BlockBounds bounds = block_bounds(grid);
  const SightOverBlocks blocks(grid, bounds, view, lines.rounding_m());
  for (int i = 0; i < 40; ++i) {
    const int column = random.whole(0, grid.columns - 1), row = random.whole(0, grid.rows - 1);
    Vec3 vertex = grid.vertex_m(column, row);
    if (std::isnan(vertex.x) || std::isnan(vertex.y)) continue;
    if (random.chance(0.3)) vertex.x += random.between(-1, 1) * cell_size_m(grid);
    ProfilePoint at = to_profile_frame(view, vertex);
    if (random.chance(0.2)) at.u = 0; // along a column or row of some
    const double distance_m = std::hypot(at.u, at.v);
    if (!(distance_m > 0.1 * cell_size_m(grid))) continue;
    const Vec2 direction{at.u / distance_m, at.v / distance_m};
    const SightLine walked = lines.up_to(direction, distance_m);
    double from_slope = std::isnan(at.z) ? 0 : (at.z - view.eye_z_m) / distance_m - 1e-6;
    if (walked.highest && random.chance(0.4))
      from_slope = walked.slope + random.pick({0.0, -1e-9, 1e-9, -1e-3, 1e-3});
    ++sums.asked;
    const auto told = blocks.up_to(direction, distance_m, from_slope);
    if (!told) continue;
    ++sums.told;
    INFO("seed " << sums.seed << ", towards " << at.u << ", " << at.v << ": " << told->slope
                 << " from " << from_slope << ", walked " << walked.slope);
    REQUIRE(told->ground.has_value() == walked.ground.has_value());
    if (walked.ground) {
      ++sums.on_ground;
      REQUIRE(std::abs(told->ground->z_m - walked.ground->z_m) <=
              told->ground->rounding_m + walked.ground->rounding_m);
    }
    if (walked.slope < from_slope) {
      ++sums.lower;
      REQUIRE(told->slope < from_slope);
      continue;
    }
    ++sums.higher;
    REQUIRE(told->slope == walked.slope);
    REQUIRE(told->highest->distance_m == walked.highest->distance_m);
  }
}

View looking_north(Vec2 from_m, double eye_z_m) {
  View view;
  view.depth_origin_m = from_m;
  view.eye_z_m = eye_z_m;
  return view;
}

} // namespace

TEST_CASE("Blocks on a map plane tell of high ground what a walk over all of it tells") {
  const Sums all = asked_of_seeds<Sums>(150, [](Random& random, Sums& sums) {
    const int columns = random.whole(2, 160), rows = random.whole(2, 160);
    GridLattice lattice{columns, rows};
    if (random.chance(0.7))
      lattice = turned_lattice(columns, rows, {random.pick({1.0, 30.0}), random.pick({1.0, 25.0})},
                               random.pick({0.0, random.between(0, 6)}), random.pick({0.0, 0.5}));
    Grid grid = made_grid(random, lattice, {});
    raise_mountains(random, grid, random.pick({0.0, 10.0, 300.0}));
    Vec2 at = grid.plane().position_m(random.whole(0, columns - 1), random.whole(0, rows - 1));
    if (random.chance(0.2)) at = at + 50 * (lattice.column_step_m + lattice.row_step_m);
    View view = looking_north(at, random.pick({2.0, 50.0, random.between(0, 400)}));
    view.exaggeration = random.pick({1.0, 2.0});
    if (random.chance(0.5))
      view.drop = {1e-4 * random.between(-0.2, 1), 1e-4 * random.share(), 1e-4 * random.share()};
    check(grid, view, random, sums);
  });
  CHECK(all.told >= enough(2000));
  CHECK(all.higher >= enough(500));
  CHECK(all.lower >= enough(500));
  CHECK(all.on_ground >= enough(1500));
}

TEST_CASE("Blocks of a grid in degrees tell of high ground what a walk over all of it tells") {
  const Sums all = asked_of_seeds<Sums>(100, [](Random& random, Sums& sums) {
    MadeEarth made = random_earth(random, 140);
    made.lon_step_deg = random.pick({1.0 / 3600, 1.0 / 1200});
    made.lat_step_deg = made.lon_step_deg;
    made.origin_lon_deg =
        made.west_deg + random.between(-0.2, 1.2) * (made.columns - 1) * made.lon_step_deg;
    made.origin_lat_deg =
        std::clamp(made.north_deg - random.between(-0.2, 1.2) * (made.rows - 1) * made.lat_step_deg,
                   -85.0, 85.0);
    Grid grid = made_grid(random, {made.columns, made.rows}, {});
    grid.lattice = earth_lattice(made);
    raise_mountains(random, grid, random.pick({0.0, 10.0, 3000.0}));
    if (leaning_triangles(grid) > 0) return;
    View view = looking_north({0, 0}, random.pick({30.0, 1000.0, random.between(0, 4000)}));
    if (random.chance(0.5)) view.drop = {-1e-8, 0, -1e-8};
    check(grid, view, random, sums);
  });
  CHECK(all.told >= enough(1000));
  CHECK(all.higher >= enough(200));
  CHECK(all.lower >= enough(200));
  CHECK(all.on_ground >= enough(800));
}

} // namespace orograph::sight_over_blocks_test
