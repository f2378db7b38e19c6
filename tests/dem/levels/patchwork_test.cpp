// SPDX-License-Identifier: GPL-3.0-or-later
// One surface of patches: that they are all of the grid, differ by one level at most, and are sewn
// together without a gap, each vertex where its definition puts it.
#include "dem/levels/generalise.hpp"
#include "dem/levels/part_of_grid.hpp"
#include "dem/levels/patchwork.hpp"
#include "dem/levels/raster_patches.hpp"
#include "dem/levels/refine.hpp"
#include "tests/catch.hpp"
#include "tests/support/earth_terrain.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace orograph::patchwork_test {
namespace {

constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();

Grid made_grid(Random& random, double voids) {
  const int columns = random.whole(2, 110), rows = random.whole(2, 110);
  std::vector<double> heights;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      heights.push_back(random.chance(voids) ? kNoHeight
                                             : 50 * std::sin(0.3 * column) * std::cos(0.2 * row) +
                                                   random.between(0, 9));
  if (random.chance(0.3)) {
    TerrainData on_earth =
        earth_terrain({8, 0.0005, columns, 46, -0.0004, rows}, [](double, double) { return 0.0; });
    Grid grid = std::get<Grid>(on_earth.surface);
    grid.heights_m = Heights<double>(std::move(heights));
    return grid;
  }
  return {columns, rows, PlaneLattice{{100, 900}, {30, 2}, {3, -40}},
          Heights<double>(std::move(heights))};
}

// About some places, as from an eye, or anywhere.
Patches made_patches(Random& random, const Grid& grid, PatchLevels levels) {
  const double column = random.between(0, grid.columns), row = random.between(0, grid.rows),
               steepness = random.pick({0.02, 0.1, 0.5});
  const bool is_wild = random.chance(0.3);
  return Patches(grid, levels, [&](int level, const PatchPlace& part) {
    if (is_wild) return random.whole(levels.finest, levels.coarsest) >= level;
    const double away =
        std::hypot(std::max({part.first_column - column, column - part.last_column, 0.0}),
                   std::max({part.first_row - row, row - part.last_row, 0.0}));
    return levels.finest + static_cast<int>(steepness * away) >= level;
  });
}

// Of each cell of the finest level, by the list of patches alone; row-major.
std::vector<int> levels_of_cells(const Patches& patches) {
  std::vector<int> levels(static_cast<std::size_t>(patches.columns() * patches.rows()), 99);
  bool are_apart = true;
  for (const Patch& patch : patches.patches()) {
    const std::int64_t side = kPatchCells * patches.cell(patch.level);
    for (std::int64_t row = patch.row * side;
         row < std::min((patch.row + 1) * side, patches.rows()); ++row)
      for (std::int64_t column = patch.column * side;
           column < std::min((patch.column + 1) * side, patches.columns()); ++column) {
        int& level = levels[static_cast<std::size_t>(row * patches.columns() + column)];
        are_apart &= level == 99; // none lies on another
        level = patch.level;
      }
  }
  REQUIRE(are_apart);
  return levels;
}

// What several cells have at a place between them.
class AtPlace {
public:
  AtPlace(const Patches& patches, const std::vector<int>& levels, std::int64_t column,
          std::int64_t row) {
    for (const std::int64_t c : {column - 1, column})
      for (const std::int64_t r : {row - 1, row})
        if (c >= 0 && r >= 0 && c < patches.columns() && r < patches.rows()) {
          const int level = levels[static_cast<std::size_t>(r * patches.columns() + c)];
          finest = std::min(finest, level);
          coarsest = std::max(coarsest, level);
        }
  }
  int finest = 99, coarsest = -99;
};

// The heights of all levels at a grid's places, each found for the whole grid.
class Levels {
public:
  Levels(const Grid& grid, const Patches& patches) : grid_(grid), patches_(patches) {
    for (int level = patches.levels().finest; level <= patches.levels().coarsest; ++level) {
      if (level < 0) fine_.push_back(refined(grid, 1 << -level));
      if (level > 0)
        nested_.push_back(nested_heights(grid, 1 << level, whole_level(grid, 1 << level),
                                         [](int, int) { return false; }));
    }
  }
  // NaN where there is none.
  double at(int level, std::int64_t column, std::int64_t row) const {
    const std::int64_t cell = patches_.cell(level);
    const auto number = [&](std::int64_t at) { return static_cast<int>((at + cell - 1) / cell); };
    if (level < 0)
      return fine_[static_cast<std::size_t>(level - patches_.levels().finest)].height_m(
          number(column), number(row));
    if (level == 0) return grid_.height_m(number(column), number(row));
    return nested_[static_cast<std::size_t>(level - 1)]
                  [static_cast<std::size_t>(number(row)) * whole_level(grid_, 1 << level).columns +
                   static_cast<std::size_t>(number(column))];
  }

private:
  const Grid& grid_;
  const Patches& patches_;
  std::vector<Grid> fine_;
  std::vector<std::vector<double>> nested_; ///< row-major
};

double area_of(const Tin& tin, std::size_t t) {
  const auto& [a, b, c] = tin.triangles[t];
  return 0.5 * cross(plan_m(tin, b) - plan_m(tin, a), plan_m(tin, c) - plan_m(tin, a));
}

} // namespace

TEST_CASE("patches are all of a grid, and differ by one level at most") {
  std::size_t seams = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Grid grid = made_grid(random, 0);
    const Patches patches = made_patches(random, grid, {-random.whole(0, 2), random.whole(0, 3)});
    const std::vector<int> levels = levels_of_cells(patches);
    REQUIRE(std::ranges::find(levels, 99) == levels.end());
    bool are_near = true, are_told = true;
    for (std::int64_t row = 0; row <= patches.rows(); ++row)
      for (std::int64_t column = 0; column <= patches.columns(); ++column) {
        const AtPlace at(patches, levels, column, row);
        are_near &= at.coarsest - at.finest <= 1;
        are_told &= patches.coarsest_at(column, row) == at.coarsest;
        seams += at.coarsest > at.finest;
      }
    REQUIRE(are_near);
    REQUIRE(are_told);
  }
  CHECK(seams > enough(1000));
}

TEST_CASE("a patchwork is one surface without gaps") {
  std::size_t seams = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    Random random(1000 + seed);
    INFO("seed " << seed);
    const Grid grid = made_grid(random, 0);
    const Patches patches = made_patches(random, grid, {-random.whole(0, 2), random.whole(0, 3)});
    const Patchwork made =
        patchwork(grid, patches, patches_of_grid(grid, patches, [](int, int) { return false; }));
    double area = 0;
    bool face_up = true, ends_at_border = true;
    for (std::size_t t = 0; t < made.tin.triangles.size(); ++t) {
      const double own = area_of(made.tin, t);
      area += own;
      face_up &= own > 0;
      for (std::size_t k = 0; k < 3; ++k) {
        if (made.tin.neighbours[t][k] != kNoTriangle) continue;
        const auto& a = made.places[made.tin.triangles[t][(k + 1) % 3]];
        const auto& b = made.places[made.tin.triangles[t][(k + 2) % 3]];
        ends_at_border &= (a[0] == b[0] && (a[0] == 0 || a[0] == patches.columns())) ||
                          (a[1] == b[1] && (a[1] == 0 || a[1] == patches.rows()));
      }
    }
    REQUIRE(face_up);
    REQUIRE(ends_at_border);
    if (!grid.is_on_earth()) {
      const double whole = 1206.0 * (grid.columns - 1) * (grid.rows - 1);
      REQUIRE(std::abs(area - whole) <= 1e-9 * whole);
    }
    const std::vector<int> levels = levels_of_cells(patches);
    const Levels heights(grid, patches);
    for (std::size_t i = 0; i < made.places.size(); ++i) {
      const auto [column, row] = made.places[i];
      const int level = AtPlace(patches, levels, column, row).coarsest;
      const std::int64_t cell = patches.cell(level);
      const auto is_line = [&](std::int64_t at, std::int64_t end) {
        return at % cell == 0 || at == end;
      };
      const bool on_column = is_line(column, patches.columns()),
                 on_row = is_line(row, patches.rows());
      REQUIRE((on_column || on_row));
      CAPTURE(column, row, level);
      if (on_column && on_row) {
        REQUIRE(made.heights_m[i] == heights.at(level, column, row));
        continue;
      }
      // Between the ends of a coarser cell's edge, as they are drawn.
      ++seams;
      const auto vertex_at = [&](std::int64_t c, std::int64_t r) {
        const std::array<std::int64_t, 2> place{c, r};
        return static_cast<std::size_t>(std::ranges::find(made.places, place) -
                                        made.places.begin());
      };
      const auto from = [&](std::int64_t at) { return at / cell * cell; };
      const auto to = [&](std::int64_t at, std::int64_t end) {
        return std::min(at / cell * cell + cell, end);
      };
      const std::size_t a = vertex_at(on_column ? column : from(column), on_row ? row : from(row)),
                        b = vertex_at(on_column ? column : to(column, patches.columns()),
                                      on_row ? row : to(row, patches.rows()));
      REQUIRE((a < made.places.size() && b < made.places.size()));
      const Vec3 p = made.tin.vertices_m[i], begin = made.tin.vertices_m[a],
                 end = made.tin.vertices_m[b];
      const double share =
          on_column ? static_cast<double>(row - from(row)) /
                          static_cast<double>(to(row, patches.rows()) - from(row))
                    : static_cast<double>(column - from(column)) /
                          static_cast<double>(to(column, patches.columns()) - from(column));
      REQUIRE(length(p - (begin + share * (end - begin))) <= 1e-9 * (1 + length(p)));
    }
  }
  CHECK(seams > enough(1000));
}

TEST_CASE("a patchwork of the file's cells is the grid's triangles, voids and all") {
  for (std::uint64_t seed = 1; seed <= last_seed(20); ++seed) {
    Random random(2000 + seed);
    INFO("seed " << seed);
    const Grid grid = made_grid(random, random.pick({0.0, 0.1, 0.5}));
    const Patches patches(grid, {-random.whole(0, 2), random.whole(0, 2)},
                          [](int level, const PatchPlace&) { return level <= 0; });
    const Patchwork made =
        patchwork(grid, patches, patches_of_grid(grid, patches, [](int, int) { return false; }));
    std::size_t triangles = 0;
    for (int row = 0; row + 1 < grid.rows; ++row)
      for (int column = 0; column + 1 < grid.columns; ++column) {
        const double ends = grid.height_m(column, row) + grid.height_m(column + 1, row + 1);
        triangles += !std::isnan(ends + grid.height_m(column + 1, row));
        triangles += !std::isnan(ends + grid.height_m(column, row + 1));
      }
    REQUIRE(made.tin.triangles.size() == triangles);
    for (const Departure& departure : made.departures) REQUIRE(departure.greatest_m == 0);
  }
}

TEST_CASE("patches of a raster in larger cells are its own near by, and made of those far away") {
  std::size_t near = 0, at_larger = 0, far = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(40); ++seed) {
    Random random(4000 + seed);
    INFO("seed " << seed);
    const Grid grid = made_grid(random, 0);
    const int of_larger = random.whole(1, 2), step = 1 << of_larger;
    const auto is_kept = [](int, int) { return false; };
    if (std::min(grid.columns, grid.rows) < 2 * step + 3) continue;
    const Grid larger = generalised(grid, step, is_kept);
    LargerCells read{step, grid.columns, grid.rows, departure_of(larger, grid), {}};
    const Patches patches = made_patches(random, grid, {0, random.whole(1, 4)});
    for (const GridPart& part : parts_under(read, patches))
      read.parts.push_back({part, part_of_grid(grid, part)});
    const Patchwork made =
        patchwork(larger, patches, patches_of_raster(larger, read, patches, is_kept));
    const Patchwork of_grid = patchwork(grid, patches, patches_of_grid(grid, patches, is_kept));
    REQUIRE(made.places == of_grid.places);
    REQUIRE(made.tin.triangles == of_grid.tin.triangles);
    const Levels levels(grid, patches);
    const std::vector<int> levels_of = levels_of_cells(patches);
    const double across = (larger.columns - 1.0) / (grid.columns - 1),
                 down = (larger.rows - 1.0) / (grid.rows - 1);
    for (std::size_t i = 0; i < made.places.size(); ++i) {
      const auto [column, row] = made.places[i];
      const int level = AtPlace(patches, levels_of, column, row).coarsest;
      const std::int64_t cell = patches.cell(level);
      if ((column % cell != 0 && column != patches.columns()) ||
          (row % cell != 0 && row != patches.rows()))
        continue; // on a coarser cell's edge
      CAPTURE(column, row, level);
      if (level < of_larger) {
        ++near;
        REQUIRE(made.heights_m[i] == levels.at(level, column, row));
        if (!grid.is_on_earth())
          REQUIRE(length(made.tin.vertices_m[i] - of_grid.tin.vertices_m[i]) < 1e-6);
        continue;
      }
      // Between four of the larger cells' vertices, or among those in reach.
      const double x = std::min(static_cast<double>(column) * across, larger.columns - 1.0),
                   y = std::min(static_cast<double>(row) * down, larger.rows - 1.0);
      const double reach = static_cast<double>(cell) / step;
      double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, mean = 0;
      for (int r = 0; r < larger.rows; ++r)
        for (int c = 0; c < larger.columns; ++c) {
          const double right = std::abs(c - x), below = std::abs(r - y);
          if (right > reach || below > reach) continue;
          lowest = std::min(lowest, larger.height_m(c, r));
          highest = std::max(highest, larger.height_m(c, r));
          if (right < 1 && below < 1) mean += (1 - right) * (1 - below) * larger.height_m(c, r);
        }
      REQUIRE((made.heights_m[i] >= lowest - 1e-9 && made.heights_m[i] <= highest + 1e-9));
      if (level == of_larger) REQUIRE(std::abs(made.heights_m[i] - mean) < 1e-9 * (1 + reach));
      ++(level == of_larger ? at_larger : far);
    }
    for (std::size_t i = 0; i < patches.patches().size(); ++i) {
      const Departure &own = made.departures[i], &whole = of_grid.departures[i];
      if (patches.patches()[i].level < of_larger)
        REQUIRE((own.greatest_m == whole.greatest_m && own.rms_m == whole.rms_m));
      else
        REQUIRE(own.greatest_m >= read.departure.greatest_m);
    }
  }
  CHECK(near > enough(10000));
  CHECK(at_larger > enough(1000));
  CHECK(far > enough(500));
}

TEST_CASE("with voids no triangle has a missing height, and each void keeps its triangles away") {
  for (std::uint64_t seed = 1; seed <= last_seed(30); ++seed) {
    Random random(3000 + seed);
    INFO("seed " << seed);
    const Grid grid = made_grid(random, random.pick({0.02, 0.2}));
    const Patches patches = made_patches(random, grid, {-random.whole(0, 2), random.whole(0, 3)});
    const Patchwork made =
        patchwork(grid, patches, patches_of_grid(grid, patches, [](int, int) { return false; }));
    REQUIRE(made.heights_m.size() == made.tin.vertices_m.size());
    REQUIRE(std::ranges::none_of(made.heights_m, [](double height) { return std::isnan(height); }));
    const std::int64_t file = patches.cell(0);
    for (const auto& [column, row] : made.places)
      if (column % file == 0 && row % file == 0 && patches.coarsest_at(column, row) <= 0)
        REQUIRE_FALSE(std::isnan(
            grid.height_m(static_cast<int>(column / file), static_cast<int>(row / file))));
  }
}

} // namespace orograph::patchwork_test
