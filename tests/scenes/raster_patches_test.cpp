// SPDX-License-Identifier: GPL-3.0-or-later
// From an eye over a raster of which larger cells were read and its own near the eye: what is drawn
// is right by the ray walk, and stands on the raster's own ground.
#include "dem/height_at.hpp"
#include "map/draw_map.hpp"
#include "placing/cell_on_page.hpp"
#include "placing/level_of_detail.hpp"
#include "placing/patches_of_raster.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/raster_in_parts.hpp"
#include "tests/support/earth_terrain.hpp"
#include "tests/support/plane_terrain.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orograph::raster_patches_test {
namespace {

double height_m(double x, double y) {
  return 300 * std::sin(x * 3) * std::cos(y * 2.3) + 120 * std::sin(11 * x + 7 * y) +
         25 * std::sin(90 * x) * std::sin(101 * y);
}

} // namespace

TEST_CASE("an eye over a raster in larger cells sees its own cells near by") {
  std::size_t asked = 0, several = 0, in_part = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(8); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const bool on_earth = seed % 3 == 0;
    const TerrainData file =
        on_earth ? earth_terrain({8, 0.0005, 300, 46, -0.0004, 280},
                                 [](double lon_deg, double lat_deg) {
                                   return height_m(40 * lon_deg, 50 * lat_deg);
                                 })
                 : plane_terrain(random.whole(250, 300), random.whole(250, 300), height_m);
    const Grid& grid = std::get<Grid>(file.surface);
    MapSpec spec;
    spec.style.detail.cell_mm = random.pick({2.0, 4.0});
    spec.check = 1000;
    if (on_earth)
      spec.view.eye_lonlat = GivenPlace{random.between(8.03, 8.12), random.between(45.9, 45.98)};
    else
      spec.view.eye_map = GivenPlace{random.between(1000, 6500), random.between(-6500, -1000)};
    spec.view.eye_height_m = random.pick({2.0, 60.0, 500.0});
    if (seed % 2 == 0) spec.view.projection = Projection::cylindrical;
    spec.view.look_azimuth = Angle::degrees(random.between(0, 360));
    TerrainData whole = in_larger_cells(file, random.pick({2, 4}));
    add_parts<PatchesOfRaster>(whole, grid, spec);
    const std::size_t parts = whole.larger_cells->parts.size();
    std::size_t heights = 0;
    for (const RasterPart& part : whole.larger_cells->parts) heights += part.cells.size();
    in_part += parts > 0 && heights < grid.size();

    TerrainOfView terrain(whole, spec.view);
    const auto level = choose_level(terrain, spec, nullptr, nullptr);
    REQUIRE(level);
    CHECK(level->step == 1);
    several += level->most_step > level->step;
    const PlacedView placed = placed_view(terrain, spec);
    // Its height is above the file's ground.
    TerrainOfView of_file(file, spec.view);
    const PlacedView on_file = placed_view(of_file, spec);
    CHECK(std::abs(placed.view.eye_z_m - on_file.view.eye_z_m) < 1e-3);
    const Map map = draw_map(*terrain, placed, spec, [](double) {});
    REQUIRE(map.facts.check);
    CHECK(map.facts.check->hidden == 0);
    CHECK(map.facts.check->missing == 0);
    asked += map.facts.check->asked;
  }
  CHECK(asked > enough<4000>);
  CHECK(several > enough<2>);
  CHECK(in_part > enough<2>);
}

TEST_CASE("ground on the page has a scale, and most of that beside it has none") {
  std::size_t on_page = 0, beside = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(20); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    // A bowl about the eye, of which nothing hides anything.
    const double x = random.between(1, 3), y = random.between(1, 3);
    const TerrainData terrain = plane_terrain(200, 200, [&](double column, double row) {
      return 100 * (std::pow(column - x, 2) + std::pow(row - y, 2));
    });
    MapSpec spec;
    spec.view.eye_map = GivenPlace{1500 * x, -1500 * y};
    spec.view.eye_height_m = random.between(2, 100);
    spec.view.look_azimuth = Angle::degrees(random.between(0, 360));
    spec.view.field_of_view = Angle::degrees(random.between(20, 100));
    if (seed % 3 == 0) spec.view.roll = Angle::degrees(random.between(-30, 30));
    const PlacedView placed = placed_picture(terrain, facts_of(terrain), spec, nullptr);
    const Grid& grid = std::get<Grid>(terrain.surface);
    const ScaleOnPage scale(grid, placed);
    for (int row = 1; row + 1 < grid.rows; row += 2)
      for (int column = 1; column + 1 < grid.columns; column += 2) {
        const double mm = scale.mm_per_m({column - 1.0, column + 1.0, row - 1.0, row + 1.0});
        const Vec3 at = placed.on_page(to_profile_frame(placed.view, grid.vertex_m(column, row)));
        if (is_on_page(placed, at)) {
          ++on_page;
          REQUIRE(mm > 0);
        } else {
          beside += mm == 0;
        }
      }
  }
  CHECK(on_page > enough<20000>);
  CHECK(beside > enough<60000>);
}

TEST_CASE("without the raster's own cells its larger ones are drawn") {
  Random random(5);
  const TerrainData whole = in_larger_cells(plane_terrain(200, 210, height_m), 4);
  MapSpec spec;
  spec.view.eye_map = GivenPlace{2000, -2000};
  spec.view.eye_height_m = 60;
  TerrainOfView terrain(whole, spec.view);
  const auto level = choose_level(terrain, spec, nullptr, nullptr);
  REQUIRE(level);
  CHECK(level->step == 4);
  CHECK(std::holds_alternative<Grid>(terrain->surface));
}

} // namespace orograph::raster_patches_test
