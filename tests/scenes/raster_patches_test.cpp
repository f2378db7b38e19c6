// SPDX-License-Identifier: GPL-3.0-or-later
// From an eye over a raster of which larger cells were read and its own near the eye: what is drawn
// is right by the ray walk, and stands on the raster's own ground.
#include "dem/height_at.hpp"
#include "dem/levels/part_of_grid.hpp"
#include "dem/levels/raster_patches.hpp"
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
#include <vector>

namespace orograph::raster_patches_test {
namespace {

double height_m(double x, double y) {
  return 300 * std::sin(x * 3) * std::cos(y * 2.3) + 120 * std::sin(11 * x + 7 * y) +
         25 * std::sin(90 * x) * std::sin(101 * y);
}

/// In degrees, or on a map plane, of sizes from `least` to `most`.
TerrainData made_raster(Random& random, bool on_earth, int least, int most) {
  if (!on_earth)
    return plane_terrain(random.whole(least, most), random.whole(least, most), height_m);
  return earth_terrain(
      {8, 0.0005, most, 46, -0.0004, most - 20},
      [](double lon_deg, double lat_deg) { return height_m(40 * lon_deg, 50 * lat_deg); });
}

} // namespace

TEST_CASE("an eye over a raster in larger cells sees its own cells near by") {
  std::size_t asked = 0, several = 0, in_part = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(8); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const bool on_earth = seed % 3 == 0;
    const TerrainData file = made_raster(random, on_earth, 250, 300);
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
    add_parts(whole, grid, spec, [&](const TerrainData& framed, const PlacedView& on) {
      const GroundRanges ranges(std::get<Grid>(framed.surface));
      return PatchesOfRaster(framed, ranges, on, spec).missing();
    });
    const std::size_t parts = whole.larger_cells->parts.size();
    std::size_t heights = 0;
    for (const RasterPart& part : whole.larger_cells->parts) heights += part.cells.size();
    in_part += parts > 0 && heights < grid.size();

    TerrainOfView terrain(whole, spec.view);
    const auto level = choose_level(terrain, spec, nullptr);
    REQUIRE(level);
    CHECK(level->step == 1);
    several += level->most_step > level->step;
    // What the larger cells are from the raster is in their patches' departures alone.
    CHECK(terrain->surface_error_m == 0);
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
  CHECK(asked > enough(4000));
  CHECK(several > enough(2));
  CHECK(in_part > enough(2));
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
    const GroundRanges ranges(grid);
    const ScaleOnPage scale(grid, ranges, placed);
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
  CHECK(on_page > enough(20000));
  CHECK(beside > enough(60000));
}

TEST_CASE("own cells that hide each other have no scale, and what is seen of them keeps it") {
  std::size_t seen = 0, hidden = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(12); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const bool on_earth = seed % 3 == 0;
    const TerrainData file = made_raster(random, on_earth, 150, 200);
    MapSpec spec;
    if (on_earth)
      spec.view.eye_lonlat = GivenPlace{random.between(8.02, 8.08), random.between(45.94, 45.98)};
    else
      spec.view.eye_map = GivenPlace{random.between(1000, 4000), random.between(-4000, -1000)};
    spec.view.eye_height_m = random.pick({2.0, 20.0, 200.0});
    spec.view.look_azimuth = Angle::degrees(random.between(0, 360));
    const TerrainOfView own(file, spec.view);
    const Grid& raster = std::get<Grid>(own->surface);
    const TerrainData in_larger = in_larger_cells(file, 4);
    const TerrainOfView of_larger(in_larger, spec.view);
    const Grid& larger = std::get<Grid>(of_larger->surface);
    const PlacedView placed = placed_picture(*own, facts_of(*own), spec, nullptr);
    const PlacedView as_read = placed_picture(*of_larger, facts_of(*of_larger), spec, nullptr);
    const GroundRanges ranges(larger);
    ScaleOnPage scale(larger, ranges, as_read, &raster);
    // Four cells about each vertex, and what it was before the raster's own were looked at.
    std::vector<std::pair<PatchPlace, double>> before;
    for (int i = 0; i < 6000; ++i) {
      const int column = random.whole(1, raster.columns - 2),
                row = random.whole(1, raster.rows - 2);
      const PatchPlace part{column - 1.0, column + 1.0, row - 1.0, row + 1.0};
      before.emplace_back(part, scale.mm_per_m(part));
    }
    const GridPart window{0, 0, raster.columns - random.whole(0, 40),
                          raster.rows - random.whole(0, 40)};
    scale.look_at_cells(window, part_of_grid(raster, window));
    const Vec3 eye{placed.view.depth_origin_m.x, placed.view.depth_origin_m.y, placed.view.eye_z_m};
    for (const auto& [part, mm] : before) {
      const double now = scale.mm_per_m(part);
      REQUIRE((now == mm || now == 0));
      hidden += now != mm;
      if (mm == 0) continue;
      const Vec3 at = raster.vertex_m(static_cast<int>(part.first_column) + 1,
                                      static_cast<int>(part.first_row) + 1);
      if (!is_on_page(placed, placed.on_page(to_profile_frame(placed.view, at)))) continue;
      bool is_seen = true;
      constexpr int kSteps = 3000;
      for (int k = 1; k < kSteps - 20 && is_seen; ++k) {
        const Vec3 on_way = eye + static_cast<double>(k) / kSteps * (at - eye);
        const auto ground = height_at(raster, {on_way.x, on_way.y}, on_way);
        is_seen = !ground || *ground < on_way.z;
      }
      if (!is_seen) continue;
      ++seen;
      REQUIRE(now > 0);
    }
  }
  CHECK(seen > enough(300));
  CHECK(hidden > enough(600));
}

TEST_CASE("only ground beside the page is coarser than far ground is shown") {
  const TerrainData file = plane_terrain(150, 150, height_m);
  const Grid& larger = std::get<Grid>(file.surface);
  constexpr int kStep = 128;
  const LargerCells read{kStep, kStep * 149 + 1, kStep * 149 + 1, {}, {}};
  const Grid raster = lattice_of_raster(larger, read);
  std::size_t coarse = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(12); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    MapSpec spec;
    spec.view.eye_map = GivenPlace{random.between(500, 4000), random.between(-4000, -500)};
    spec.view.eye_height_m = 400;
    spec.view.look_azimuth = Angle::degrees(random.between(0, 360));
    spec.view.field_of_view = Angle::degrees(random.between(20, 100));
    const PlacedView placed = placed_picture(file, facts_of(file), spec, nullptr);
    const GroundRanges ranges(larger);
    const ScaleOnPage scale(larger, ranges, placed, &raster);
    const Patches patches = patches_of_view(raster, scale, {1, 1}, 0);
    for (const Patch& patch : patches.patches()) {
      if (patch.level <= kCoarsestShown) continue;
      ++coarse;
      const PatchPlace place = patches.place_of(patch);
      const auto vertex = [](double of_raster) { return static_cast<int>(of_raster / kStep); };
      for (int row = vertex(place.first_row); row <= vertex(place.last_row); ++row)
        for (int column = vertex(place.first_column); column <= vertex(place.last_column); ++column)
          REQUIRE_FALSE(is_on_page(
              placed, placed.on_page(to_profile_frame(placed.view, larger.vertex_m(column, row)))));
    }
  }
  CHECK(coarse > enough(12));
}

TEST_CASE("without the raster's own cells its larger ones are drawn") {
  Random random(5);
  const TerrainData whole = in_larger_cells(plane_terrain(200, 210, height_m), 4);
  MapSpec spec;
  spec.view.eye_map = GivenPlace{2000, -2000};
  spec.view.eye_height_m = 60;
  TerrainOfView terrain(whole, spec.view);
  const auto level = choose_level(terrain, spec, nullptr);
  REQUIRE(level);
  CHECK(level->step == 4);
  CHECK(std::holds_alternative<Grid>(terrain->surface));
}

} // namespace orograph::raster_patches_test
