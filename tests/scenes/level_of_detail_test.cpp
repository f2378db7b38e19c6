// SPDX-License-Identifier: GPL-3.0-or-later
// Terrain in cells as large as the page asks for: it is drawn as a terrain that has such cells, and
// what is told of it is so.
#include "dem/height_at.hpp"
#include "map/draw_map.hpp"
#include "placing/cell_on_page.hpp"
#include "placing/land_part.hpp"
#include "placing/level_of_detail.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/same_drawing.hpp"
#include "tests/support/earth_terrain.hpp"
#include "tests/support/plane_terrain.hpp"
#include "tests/support/random.hpp"

#include <cmath>

namespace orograph::level_of_detail_test {
namespace {

double height_m(double x, double y) {
  return 300 * std::sin(x * 3) * std::cos(y * 2.3) + 120 * std::sin(11 * x + 7 * y) +
         25 * std::sin(90 * x) * std::sin(101 * y);
}

TerrainData made_terrain(Random& random, int least = 150, int most = 260) {
  const int columns = random.whole(least, most), rows = random.whole(least, most);
  return plane_terrain(columns, rows, height_m);
}

TerrainData degree_terrain() {
  return earth_terrain({8, 0.0005, 200, 46, -0.0004, 210}, [](double lon_deg, double lat_deg) {
    return height_m(40 * lon_deg, 50 * lat_deg);
  });
}

MapSpec detailed(double cell_mm) {
  MapSpec spec;
  spec.style.detail.cell_mm = cell_mm;
  spec.check = 3000;
  return spec;
}

struct Drawn {
  Map map;
  std::optional<LevelOfDetail> level;
};

Drawn draw(const TerrainData& whole, const MapSpec& spec) {
  TerrainOfView terrain(whole, spec.view);
  const auto level = choose_level(terrain, spec, nullptr);
  return {draw_map(*terrain, placed_view(terrain, spec), spec, [](double) {}), level};
}

} // namespace

TEST_CASE("a level is drawn as the terrain that it is, and by the ray walk rightly") {
  std::size_t moved = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(10); ++seed) {
    Random random(seed);
    const bool on_earth = seed % 3 == 0;
    const TerrainData whole = on_earth ? degree_terrain() : made_terrain(random);
    MapSpec spec = detailed(random.between(2.5, 9));
    spec.view.from_azimuth = Angle::degrees(random.between(0, 360));
    spec.view.from_elevation = Angle::degrees(random.between(5, 70));
    TerrainOfView terrain(whole, spec.view);
    const auto level = choose_level(terrain, spec, nullptr);
    INFO("seed " << seed);
    REQUIRE(level);
    CHECK(level->step >= 2);
    CHECK(level->cell_mm <= spec.style.detail.cell_mm.value() * std::sqrt(2) * 1.001);
    CHECK(level->cell_mm >= spec.style.detail.cell_mm.value() / std::sqrt(2) / 1.001);
    CHECK(level->summits_moved <= level->summits);
    CHECK((level->summits_moved > 0) == (level->summit_moved_mm > 0.3));
    moved += level->summits_moved;
    const Map map = draw_map(*terrain, placed_view(terrain, spec), spec, [](double) {});
    REQUIRE(map.facts.check);
    CHECK(map.facts.check->asked > 1000);
    CHECK(map.facts.check->hidden == 0);
    CHECK(map.facts.check->missing == 0);

    // As another terrain of those heights.
    MapSpec as_it_is = spec;
    as_it_is.style.detail = {true, {}};
    const Map again = draw_map(*terrain, placed_view(*terrain, as_it_is), as_it_is, [](double) {});
    CHECK(difference(map.drawing, again.drawing).empty());
  }
  CHECK(moved > 0);
}

TEST_CASE("the file's own surface is drawn where it is asked for, or is coarse enough",
          "[unsanitized]") {
  Random random(1);
  const TerrainData whole = made_terrain(random);
  MapSpec spec = detailed(1.4); // cells of more than a millimetre
  const Drawn fine = draw(whole, spec);
  CHECK_FALSE(fine.level);
  spec.style.detail = {};
  CHECK_FALSE(draw(whole, spec).level);
  spec.style.detail = {true, {}};
  const Drawn of_file = draw(whole, spec);
  CHECK_FALSE(of_file.level);
  CHECK(difference(fine.map.drawing, of_file.map.drawing).empty());
  spec.style.detail = {};
  spec.page.width_mm = 60;
  spec.page.height_mm = 40;
  CHECK(draw(whole, spec).level);
  spec.ground_points = true;
  CHECK_FALSE(draw(whole, spec).level);
  spec.style.detail.cell_mm = 2;
  CHECK(draw(whole, spec).level);
}

TEST_CASE("smaller cells are drawn as the terrain that they are, and by the ray walk rightly") {
  for (std::uint64_t seed = 1; seed <= last_seed(12); ++seed) {
    Random random(100 + seed);
    const bool on_earth = seed % 3 == 0;
    const TerrainData whole = on_earth
                                  ? earth_terrain({8, 0.0005, 33, 46, -0.0004, 41},
                                                  [&](double lon_deg, double lat_deg) {
                                                    return height_m(40 * lon_deg, 50 * lat_deg);
                                                  })
                                  : made_terrain(random, 20, 60);
    MapSpec spec = detailed(random.between(0.6, 2));
    spec.view.from_azimuth = Angle::degrees(random.between(0, 360));
    spec.view.from_elevation = Angle::degrees(random.between(5, 70));
    INFO("seed " << seed);
    const Drawn drawn = draw(whole, spec);
    REQUIRE(drawn.level);
    CHECK(drawn.level->step < 1);
    CHECK(drawn.level->summits > 0);
    CHECK(drawn.level->summit_moved_mm == 0);
    CHECK(drawn.level->summits_moved == 0);
    CHECK(drawn.level->greatest_m > drawn.level->rms_m);
    REQUIRE(drawn.map.facts.check);
    CHECK(drawn.map.facts.check->asked > 1000);
    CHECK(drawn.map.facts.check->hidden == 0);
    CHECK(drawn.map.facts.check->missing == 0);
  }
}

TEST_CASE("an eye sees patches, smooth ones unless it stands close above its cells",
          "[unsanitized]") {
  Random random(2);
  const TerrainData whole = made_terrain(random);
  MapSpec spec = detailed(5);
  spec.view.eye_map = GivenPlace{2000, -2000};
  spec.view.eye_height_m = 100;
  const Drawn smooth = draw(whole, spec);
  REQUIRE(smooth.level);
  CHECK(smooth.level->step < 1);
  CHECK(smooth.map.facts.check->hidden + smooth.map.facts.check->missing == 0);
  spec.style.detail = {};
  const Drawn by_default = draw(whole, spec);
  REQUIRE(by_default.level);
  CHECK(by_default.level->step < 1);
  CHECK(by_default.map.facts.check->hidden + by_default.map.facts.check->missing == 0);
  spec.view.eye_height_m = 2;
  const Drawn close = draw(whole, spec);
  CHECK((!close.level || close.level->step >= 1));
  CHECK(close.map.facts.check->hidden + close.map.facts.check->missing == 0);
  spec.view.eye_height_m = 100;
  spec.style.underside = Underside::draw;
  CHECK_FALSE(draw(whole, spec).level);
}

TEST_CASE("an eye stands over the ground anywhere within a grid's borders") {
  Random random(3);
  for (const bool on_earth : {false, true}) {
    const TerrainData whole = on_earth ? degree_terrain() : made_terrain(random);
    const Grid& grid = std::get<Grid>(whole.surface);
    const TerrainFacts facts = facts_of(whole);
    for (int i = 0; i < 400; ++i) {
      const int column = random.whole(0, grid.columns - 2), row = random.whole(0, grid.rows - 2);
      const Vec3 from = grid.vertex_m(column, row), to = grid.vertex_m(column + 1, row + 1);
      const Vec2 within{from.x + random.between(0, 1) * (to.x - from.x),
                        from.y + random.between(0, 1) * (to.y - from.y)};
      CHECK(stands_over(grid, facts.extent.blocks.boxes, within));
    }
    const Vec3 first = grid.vertex_m(0, 0), next = grid.vertex_m(1, 1);
    CHECK_FALSE(
        stands_over(grid, facts.extent.blocks.boxes, {2 * first.x - next.x, 2 * first.y - next.y}));
  }
}

TEST_CASE("patches about an eye are drawn rightly by the ray walk") {
  std::size_t asked = 0, several = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(9); ++seed) {
    Random random(200 + seed);
    INFO("seed " << seed);
    const bool on_earth = seed % 3 == 0;
    const TerrainData whole = on_earth
                                  ? earth_terrain({8, 0.0005, 90, 46, -0.0004, 80},
                                                  [](double lon_deg, double lat_deg) {
                                                    return height_m(40 * lon_deg, 50 * lat_deg);
                                                  })
                                  : made_terrain(random, 70, 100);
    MapSpec spec = detailed(random.pick({3.0, 4.0, 6.0}));
    spec.check = 1500;
    if (on_earth)
      spec.view.eye_lonlat = GivenPlace{random.between(8.01, 8.035), random.between(45.972, 45.99)};
    else
      spec.view.eye_map = GivenPlace{random.between(500, 1500), random.between(-1500, -500)};
    spec.view.eye_height_m = random.pick({2.0, 60.0, 500.0});
    if (seed % 2 == 0) spec.view.projection = Projection::cylindrical;
    spec.view.look_azimuth = Angle::degrees(random.between(0, 360));
    const Drawn drawn = draw(whole, spec);
    if (!drawn.level) continue;                            // the file's cells are right everywhere
    several += drawn.level->step < drawn.level->most_step; // of what is seen
    CHECK(drawn.level->greatest_m >= drawn.level->rms_m);
    REQUIRE(drawn.map.facts.check);
    CHECK(drawn.map.facts.check->hidden == 0);
    CHECK(drawn.map.facts.check->missing == 0);
    asked += drawn.map.facts.check->asked;
  }
  CHECK(asked > enough(5000));
  CHECK(several > enough(5));
}

TEST_CASE("a lake in patches stays level and has its shore, on the earth too") {
  for (const bool on_earth : {false, true}) {
    const auto lake = [](double column, double row) {
      const double away = std::hypot(column - 120, row - 130);
      return away < 45 ? 37.25
                       : 38 + 0.9 * (away - 45) + 3 * std::sin(column * 0.7) * std::sin(row * 0.9);
    };
    TerrainData whole;
    MapSpec spec = detailed(2);
    spec.view.eye_height_m = 60;
    spec.view.projection = Projection::cylindrical;
    if (on_earth) {
      whole = earth_terrain({8, 0.0005, 240, 46, -0.0004, 240}, [&](double lon, double lat) {
        return lake((lon - 8) / 0.0005, (46 - lat) / 0.0004);
      });
      spec.view.eye_lonlat = GivenPlace{8.04, 45.96};
    } else {
      std::vector<float> heights;
      for (int row = 0; row < 240; ++row)
        for (int column = 0; column < 240; ++column)
          heights.push_back(static_cast<float>(lake(column, row)));
      whole.surface = Grid{240, 240, PlaneLattice{{0, 0}, {30, 0}, {0, -30}},
                           Heights<float>(std::move(heights))};
      spec.view.eye_map = GivenPlace{2400, -3000};
    }
    TerrainOfView terrain(whole, spec.view);
    REQUIRE(choose_level(terrain, spec, nullptr));
    const PlacedView placed = placed_view(terrain, spec);
    CHECK(placed.level.regions == 1);
    CHECK_FALSE(placed.level.shores.empty());
  }
}

TEST_CASE("a lake stays level, with a shore, and the sea where it is") {
  std::vector<float> heights;
  for (int row = 0; row < 240; ++row)
    for (int column = 0; column < 240; ++column) {
      const double away = std::hypot(column - 120, row - 130);
      heights.push_back(away < 45
                            ? 37.25F
                            : static_cast<float>(38 + 0.9 * (away - 45) +
                                                 3 * std::sin(column * 0.7) * std::sin(row * 0.9)));
    }
  TerrainData whole;
  whole.surface =
      Grid{240, 240, PlaneLattice{{0, 0}, {30, 0}, {0, -30}}, Heights<float>(std::move(heights))};
  MapSpec spec = detailed(5);
  spec.view.from_elevation = Angle::degrees(50);
  TerrainOfView terrain(whole, spec.view);
  const auto level = choose_level(terrain, spec, nullptr);
  REQUIRE(level);
  CHECK(level->step == 4);
  const PlacedView placed = placed_view(terrain, spec);
  CHECK(placed.level.regions == 1);
  CHECK_FALSE(placed.level.shores.empty());
  const Grid& grid = std::get<Grid>((*terrain).surface);
  CHECK(height_at(grid, {120 * 30.0, -130 * 30.0}) == 37.25);
}

TEST_CASE("of an island the page shows the land, and what is draped over the sea all of it",
          "[unsanitized]") {
  constexpr int kSide = 200;
  std::vector<float> heights(static_cast<std::size_t>(kSide) * kSide, 0.0F);
  // Land in columns 120 to 160 and rows 30 to 60.
  for (int row = 30; row <= 60; ++row)
    for (int column = 120; column <= 160; ++column)
      heights[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(column)] =
          static_cast<float>(20 + 10 * std::sin(column) * std::cos(row));
  for (const bool on_earth : {false, true}) {
    TerrainData whole;
    if (on_earth)
      whole = earth_terrain(
          {8, 0.0005, kSide, 46, -0.0004, kSide}, [&](double lon_deg, double lat_deg) {
            const long column = std::lround((lon_deg - 8) / 0.0005),
                       row = std::lround((46 - lat_deg) / 0.0004);
            return static_cast<double>(heights[static_cast<std::size_t>(row * kSide + column)]);
          });
    else
      whole.surface =
          Grid{kSide, kSide, PlaneLattice{{0, 0}, {30, 0}, {0, -30}}, Heights<float>(heights)};
    const Grid& grid = std::get<Grid>(whole.surface);
    const TriangleSet water = facts_of(whole).water.triangles;
    MapSpec spec;
    const auto part = land_part(grid, water, spec);
    REQUIRE(part);
    // A cell more than the land on each side, for its shore's triangles, and two of water.
    CHECK(part->first_column == 117);
    CHECK(part->first_row == 27);
    CHECK(part->columns == 163 - 117 + 1);
    CHECK(part->rows == 63 - 27 + 1);
    const Grid land = part_of_grid(grid, *part);
    for (int row = 0; row < land.rows; row += 7)
      for (int column = 0; column < land.columns; column += 7) {
        const Vec3 a = land.vertex_m(column, row),
                   b = grid.vertex_m(part->first_column + column, part->first_row + row);
        CHECK(length(a - b) < 1e-8);
      }
    spec.check = 3000;
    const Drawn drawn = draw(whole, spec);
    REQUIRE(drawn.level);
    REQUIRE(drawn.map.facts.check);
    CHECK(drawn.map.facts.check->asked > 1000);
    CHECK(drawn.map.facts.check->hidden == 0);
    CHECK(drawn.map.facts.check->missing == 0);

    const auto none_with = [&](const auto& change) {
      MapSpec other;
      change(other);
      return !land_part(grid, water, other);
    };
    CHECK(none_with([](MapSpec& s) { s.style.flat = FlatGround::draw; }));
    CHECK(none_with([](MapSpec& s) { s.style.flat = FlatGround::waterlines; }));
    CHECK(none_with([](MapSpec& s) { s.style.layers.push_back({"graticule"}); }));
    CHECK(none_with([](MapSpec& s) { s.view.eye_map = GivenPlace(100, 100); }));
  }
  const TerrainData inland = degree_terrain();
  CHECK_FALSE(land_part(std::get<Grid>(inland.surface), facts_of(inland).water.triangles, {}));
}

} // namespace orograph::level_of_detail_test
