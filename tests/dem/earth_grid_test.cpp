// SPDX-License-Identifier: GPL-3.0-or-later
// Grids on the ellipsoid: their extent, the height at a point, and other frames, against every
// vertex and triangle by itself.
#include "dem/extent.hpp"
#include "dem/height_at.hpp"
#include "dem/limit_lean.hpp"
#include "dem/terrain.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace orograph::earth_grid_test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// About an origin that may lie far away.
TerrainData made_terrain(Random& random, double missing, double rise_m = 40, int widest = 70) {
  TerrainData terrain;
  Grid& grid = grid_of(terrain);
  grid.columns = random.whole(2, widest);
  grid.rows = random.whole(2, 70);
  const double step_deg = random.pick({1. / 3600, 1. / 1200, 0.02});
  const double south = random.between(-80, 80), west = random.between(-190, 360);
  const DegreeLattice lattice{west,         random.pick({1.0, 1.5}) * step_deg,
                              grid.columns, south + step_deg * (grid.rows - 1),
                              -step_deg,    grid.rows};
  const double away = random.pick({0.0, 0.5, 2.0});
  const LocalFrame frame(west + random.between(-away, away), south + random.between(-away, away));
  terrain.map.earth = EarthFrame{frame, 1, random.pick({1.0, 2.5})};
  grid.lattice = EarthLattice(lattice, frame, terrain.map.earth->exaggeration);
  std::vector<double> heights(grid.size());
  double height = 500;
  for (double& h : heights) {
    height = std::clamp(height + random.between(-rise_m, rise_m), -100.0, 4000.0);
    h = random.chance(missing) ? kNone : height;
  }
  heights[heights.size() / 2] = 100; // one that is there
  if (random.chance(0.5))
    grid.heights_m = std::vector<float>(heights.begin(), heights.end());
  else
    grid.heights_m = std::move(heights);
  return terrain;
}

// The triangle's height above a point, if it holds it, and by how much of itself it does.
struct Above {
  double share, z;
};
Above above(const std::array<Vec3, 3>& t, Vec2 p) {
  const auto area = [](Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); };
  const auto flat = [](Vec3 v) { return Vec2{v.x, v.y}; };
  const Vec2 a = flat(t[0]), b = flat(t[1]), c = flat(t[2]);
  const double all = area(a, b, c), wa = area(p, b, c) / all, wb = area(a, p, c) / all,
               wc = area(a, b, p) / all;
  if (!(all > 0)) return {-1, 0}; // leans beyond upright
  return {std::min({wa, wb, wc}), wa * t[0].z + wb * t[1].z + wc * t[2].z};
}

std::vector<std::array<Vec3, 3>> drawn_triangles_of(const Grid& grid) {
  std::vector<std::array<Vec3, 3>> triangles;
  for (int r = 0; r + 1 < grid.rows; ++r)
    for (int c = 0; c + 1 < grid.columns; ++c) {
      const Vec3 nw = grid.vertex_m(c, r), ne = grid.vertex_m(c + 1, r),
                 sw = grid.vertex_m(c, r + 1), se = grid.vertex_m(c + 1, r + 1);
      for (const auto& triangle : {std::array{nw, sw, se}, std::array{nw, se, ne}})
        if (!std::isnan(triangle[0].z + triangle[1].z + triangle[2].z))
          triangles.push_back(triangle);
    }
  return triangles;
}

} // namespace

TEST_CASE("the extent of a grid on the ellipsoid is that of its vertices") {
  std::size_t all_turned = 0, known_upright = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(120); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const TerrainData terrain = made_terrain(random, random.pick({0.0, 0.3, 0.97}),
                                             random.pick({40., 2000.}), // cliffs lean over
                                             random.pick({70, 290}));
    const Grid& grid = grid_of(terrain);
    SurfaceExtent extent = extent_of(grid);
    Box3 box;
    double sum = 0;
    std::size_t valid = 0;
    for (int r = 0; r < grid.rows; ++r)
      for (int c = 0; c < grid.columns; ++c) {
        const Vec3 at = grid.vertex_m(c, r);
        if (std::isnan(at.z)) continue;
        box.include(at);
        sum += at.z;
        ++valid;
      }
    CHECK(extent.valid == valid);
    CHECK(extent.box.low == box.low);
    CHECK(extent.box.high == box.high);
    CHECK(std::abs(extent.mean_height_m - sum / static_cast<double>(valid)) <= 1e-9 * 1e5);
    CHECK(reach_m(terrain.surface) >=
          std::max({std::hypot(box.low.x, box.low.y), std::hypot(box.high.x, box.high.y)}) / 1.5);
    std::size_t in_blocks = 0;
    for (std::size_t i = 0; i < extent.blocks.boxes.size(); ++i) {
      Box3 of_block;
      for (const Vec3& p : extent.blocks.points(i)) {
        of_block.include(p);
        ++in_blocks;
      }
      REQUIRE(extent.blocks.boxes[i].low == of_block.low);
      REQUIRE(extent.blocks.boxes[i].high == of_block.high);
    }
    CHECK(in_blocks == valid);
    const auto triangles = drawn_triangles_of(grid);
    const auto turned = std::count_if(triangles.begin(), triangles.end(), [](const auto& t) {
      return cross(Vec2{t[1].x - t[0].x, t[1].y - t[0].y}, Vec2{t[2].x - t[0].x, t[2].y - t[0].y}) <
             0;
    });
    CHECK(extent.turned_over == static_cast<std::size_t>(turned));
    all_turned += extent.turned_over;
    Grid limited = grid;
    limit_lean(limited);
    if (limited.earth().is_upright()) {
      ++known_upright;
      CHECK(turned == 0);
      SurfaceExtent again = extent_of(limited);
      CHECK(again.box.low == box.low);
      CHECK(again.box.high == box.high);
      CHECK(again.turned_over == 0);
    }

    const HeightRange range = height_range(grid);
    double low = 1e9, high = -1e9;
    for (int r = 0; r < grid.rows; ++r)
      for (int c = 0; c < grid.columns; ++c) {
        low = std::fmin(low, grid.height_m(c, r));
        high = std::fmax(high, grid.height_m(c, r));
      }
    CHECK(range.low_m == low);
    CHECK(range.high_m == high);
  }
  CHECK(all_turned >= enough(2));
  CHECK(known_upright >= enough(10));
}

TEST_CASE("triangles that lean beyond upright are counted") {
  // Uprights lean by a degree 111 km north of the origin; a cliff of 89.5 degrees that faces the
  // origin leans over, one that faces away doesn't.
  struct Size {
    int columns = 3, rows = 3, cliff = 1; // below so many rows
  };
  const auto turned = [](double north_deg, bool faces_south, double cliff_m, Size size = {}) {
    const auto [columns, rows, cliff] = size;
    Grid grid;
    grid.columns = columns;
    grid.rows = rows;
    const DegreeLattice lattice{0, 1e-4, columns, north_deg + 1e-4 * cliff, -1e-4, rows};
    grid.lattice = EarthLattice(lattice, LocalFrame(0, 0));
    std::vector<double> heights(grid.size(), 0.0);
    for (int row = 0; row < rows; ++row)
      if ((row < cliff) == faces_south)
        std::fill_n(heights.begin() + row * columns, columns, cliff_m);
    grid.heights_m = std::move(heights);
    return extent_of(grid).turned_over;
  };
  const double cell_m = 1e-4 * 110574;
  CHECK(turned(1, false, cell_m / std::tan(0.5 * M_PI / 180)) == 4);
  CHECK(turned(1, true, cell_m / std::tan(0.5 * M_PI / 180)) == 0);
  CHECK(turned(1, false, cell_m / std::tan(1.5 * M_PI / 180)) == 0);
  CHECK(turned(0, false, cell_m / std::tan(0.5 * M_PI / 180)) == 0);
  // Wherever it is among the blocks that are looked at together.
  for (const int columns : {32, 33, 128, 129, 130, 300})
    for (const int cliff : {1, 2, 31, 32, 33, 64}) {
      CAPTURE(columns, cliff);
      CHECK(turned(1, false, cell_m / std::tan(0.5 * M_PI / 180), {columns, 66, cliff}) ==
            2 * static_cast<std::size_t>(columns - 1));
    }
}

TEST_CASE("the height at a point on the ellipsoid is that of the triangle that holds it") {
  std::size_t inside = 0, outside = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const TerrainData terrain = made_terrain(random, random.pick({0.0, 0.2}));
    const Grid& grid = grid_of(terrain);
    const auto triangles = drawn_triangles_of(grid);
    if (triangles.empty()) continue;
    const Box3 box = extent_of(grid).box;
    const Vec3 size = box.high - box.low;
    for (int i = 0; i < 40; ++i) {
      const Vec2 p{random.between(box.low.x - 0.1 * size.x, box.high.x + 0.1 * size.x),
                   random.between(box.low.y - 0.1 * size.y, box.high.y + 0.1 * size.y)};
      CAPTURE(p.x, p.y);
      Above best{-1, 0};
      for (const auto& triangle : triangles)
        if (const Above found = above(triangle, p); found.share > best.share) best = found;
      const auto height = height_at(grid, p);
      if (best.share > 1e-9) {
        REQUIRE(height);
        REQUIRE(std::abs(*height - best.z) <= 1e-6);
        ++inside;
      } else if (best.share < -1e-9) {
        REQUIRE(!height);
        ++outside;
      }
    }
    for (int i = 0; i < 10; ++i) { // at vertices, which are exact but for rounding
      const int c = random.whole(0, grid.columns - 1), r = random.whole(0, grid.rows - 1);
      const Vec3 vertex = grid.vertex_m(c, r);
      const bool is_used =
          std::any_of(triangles.begin(), triangles.end(), [&](const auto& triangle) {
            return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
          });
      if (!is_used) continue;
      const auto height = height_at(grid, {vertex.x, vertex.y});
      if (height) CHECK(std::abs(*height - vertex.z) <= 1e-6);
    }
  }
  CHECK(inside > enough(800));
  CHECK(outside > enough(200));
}

TEST_CASE("another frame has every vertex at the same place of the earth") {
  for (std::uint64_t seed = 1; seed <= last_seed(40); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    TerrainData terrain = made_terrain(random, 0.1);
    const DegreeLattice lattice = grid_of(terrain).earth().degrees();
    const double lon = lattice.first_lon_deg + random.between(-3, 3),
                 lat = lattice.first_lat_deg + random.between(-3, 3),
                 exaggeration = random.pick({1.0, 3.0});
    reframe(terrain, lon, lat, exaggeration);
    const Grid& grid = grid_of(terrain);
    const Vec3 below = terrain.map.to_ground_m({lon, lat, 0});
    CHECK(length(below) <= 1e-8);
    CHECK(terrain.map.to_ground_m({lon, lat, 10}).z == Approx(10 * exaggeration).epsilon(1e-9));
    for (int i = 0; i < 30; ++i) {
      const int c = random.whole(0, grid.columns - 1), r = random.whole(0, grid.rows - 1);
      if (std::isnan(grid.height_m(c, r))) continue;
      const Vec3 on_map = terrain.map.to_map(grid.vertex_m(c, r));
      CHECK(std::abs(on_map.x - lattice.lon_deg(c)) <=
            1e-12 * 360 + 1e-13 / std::cos(lat * M_PI / 180));
      CHECK(std::abs(on_map.y - lattice.lat_deg(r)) <= 1e-12);
      CHECK(std::abs(on_map.z - grid.height_m(c, r)) <= 1e-8);
      const Vec3 back = terrain.map.to_ground_m(on_map);
      CHECK(length(back - grid.vertex_m(c, r)) <= 2e-8);
    }
  }
}

TEST_CASE("a terrain that reaches too far round the earth is refused") {
  TerrainData terrain;
  terrain.source = "world.tif";
  Grid& grid = grid_of(terrain);
  grid.columns = grid.rows = 3;
  grid.heights_m = std::vector<float>(9, 0);
  const LocalFrame frame(0, 0);
  terrain.map.earth = EarthFrame{frame, 1, 1};
  const auto is_refused = [&](double step_deg) {
    grid.lattice = EarthLattice({-step_deg, step_deg, 3, step_deg, -step_deg, 3}, frame);
    try {
      reframe(terrain, 0, 0, 1);
    } catch (const Error& error) {
      return std::string(error.what()).find("world.tif reaches") != std::string::npos;
    }
    return false;
  };
  CHECK(!is_refused(40)); // corners 54 degrees away
  CHECK(is_refused(50));  // 66
}

} // namespace orograph::earth_grid_test
