// SPDX-License-Identifier: GPL-3.0-or-later
// The sample terrains: what is committed can be read, and is what the program makes.
#include "data_samples/noise.hpp"
#include "data_samples/terrains.hpp"
#include "dem/extent.hpp"
#include "dem/read/read_raster.hpp"
#include "tests/catch.hpp"
#include "tests/support/grid_of.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace orograph::samples_test {
namespace {

struct Sample {
  const char* name;
  int columns, rows;
  double cell_m, low_m, high_m;
};

constexpr Sample samples[] = {
    {"fractal_alps", 301, 301, 80, 559.1, 3553.2},
    {"islands", 301, 301, 20000. / 300, 0, 1670.9},
    {"ridge_and_valley", 301, 301, 100, 163.6, 772},
    {"plateau", 301, 301, 40, 284.8, 1100},
    {"saddle", 301, 301, 20, 300, 1300},
    {"cone", 301, 301, 4000. / 300, 0, 1200},
    {"jacksboro", 344, 363, 85, 241, 1075},
    {"volcano", 61, 87, 10, 94, 195},
};

std::string path_of(const std::string& name) {
  return std::string(OROGRAPH_SOURCE_DIR) + "/data_samples/" + name + ".tif";
}

} // namespace

TEST_CASE("every sample is read, with its size, cells and heights") {
  for (const Sample& sample : samples) {
    INFO(sample.name);
    const TerrainData terrain = read_raster(path_of(sample.name));
    const SurfaceExtent extent = extent_of(grid_of(terrain));
    CHECK(terrain.notes.empty());
    CHECK(grid_of(terrain).columns == sample.columns);
    CHECK(grid_of(terrain).rows == sample.rows);
    CHECK(std::abs(cell_size_m(grid_of(terrain)) - sample.cell_m) <= 1e-9);
    CHECK(extent.valid == grid_of(terrain).size());
    // Heights are kept as float, to 1e-4 m or better.
    CHECK(std::abs(extent.box.low.z - sample.low_m) <= 1e-3);
    CHECK(std::abs(extent.box.high.z - sample.high_m) <= 1e-3);
    CHECK(terrain.map.crs_name.find("EPSG") != std::string::npos);
    CHECK(std::filesystem::file_size(path_of(sample.name)) < 300000);
  }
}

TEST_CASE("made samples are what the program makes today") {
  for (const MadeTerrain kind : all_made_terrains) {
    INFO(name_of(kind));
    const Grid kept = grid_of(read_raster(path_of(name_of(kind))));
    const Grid made = make_terrain(kind, kept.columns);
    double largest = 0;
    for (int row = 0; row < kept.rows; ++row)
      for (int column = 0; column < kept.columns; ++column)
        largest =
            std::max(largest, std::abs(kept.height_m(column, row) - made.height_m(column, row)));
    // Rounded to decimetres, and to float at 4000 m.
    CHECK(largest <= 0.0505);
    CHECK(std::abs(kept.plane().column_step_m.x - made.plane().column_step_m.x) <= 1e-9);
  }
}

TEST_CASE("the archipelago has the islands' heights, a degree wide") {
  const TerrainData terrain = read_raster(path_of("archipelago"));
  const Grid& kept = grid_of(terrain);
  CHECK(terrain.notes.empty());
  REQUIRE(kept.is_on_earth());
  const DegreeLattice& lattice = kept.earth().degrees();
  CHECK(std::abs(lattice.lon_deg(0) - 2) <= 1e-12);
  CHECK(std::abs(lattice.lon_deg(kept.columns - 1) - 3) <= 1e-12);
  CHECK(std::abs(lattice.lat_deg(0) - 1) <= 1e-12);
  CHECK(std::abs(lattice.lat_deg(kept.rows - 1)) <= 1e-12);
  const Grid islands = grid_of(read_raster(path_of("islands")));
  CHECK(kept.heights_m == islands.heights_m);
}

TEST_CASE("the volcano's crater opens where it does in nature") {
  const Grid grid = grid_of(read_raster(path_of("volcano")));
  // The summit is on the southern rim, the crater's floor north of it, lower than the rim around.
  const auto& heights = std::get<Heights<float>>(grid.heights_m);
  const auto highest = std::max_element(heights.begin(), heights.end()) - heights.begin();
  const int summit_row = static_cast<int>(highest) / grid.columns;
  const int summit_column = static_cast<int>(highest) % grid.columns;
  CHECK(summit_row > grid.rows * 3 / 4);
  const double floor = grid.height_m(27, 58);
  CHECK(floor < 165);
  for (const auto& [column, row] : {std::pair{summit_column, summit_row}, {17, 58}, {38, 60}})
    CHECK(grid.height_m(column, row) > floor + 15);
}

TEST_CASE("the islands' sea is flat and reaches every border") {
  const Grid grid = make_terrain(MadeTerrain::islands, 201);
  const auto& heights = std::get<Heights<float>>(grid.heights_m);
  const auto sea = std::count(heights.begin(), heights.end(), 0.f);
  CHECK(sea > 201 * 201 / 2);
  CHECK(sea < 201 * 201 * 9 / 10);
  for (int i = 0; i < 201; ++i)
    for (const double height :
         {grid.height_m(i, 0), grid.height_m(i, 200), grid.height_m(0, i), grid.height_m(200, i)})
      CHECK(height == 0);
}

TEST_CASE("plain made terrains are what their names say") {
  const Grid cone = make_terrain(MadeTerrain::cone, 101);
  CHECK(cone.height_m(50, 50) == 1200);
  CHECK(cone.height_m(0, 0) == 0);
  CHECK(std::abs(cone.height_m(70, 50) - 600) <= 1e-3); // 800 m from the summit, float
  const Grid saddle = make_terrain(MadeTerrain::saddle, 101);
  CHECK(saddle.height_m(50, 50) == 800);
  CHECK(saddle.height_m(100, 50) == 1300);
  CHECK(saddle.height_m(50, 0) == 300);
  CHECK(make_terrain(MadeTerrain::plateau, 101).height_m(50, 50) == 1100);
}

TEST_CASE("a made height doesn't depend on the size of the grid") {
  for (const MadeTerrain kind : all_made_terrains) {
    const Grid coarse = make_terrain(kind, 17), fine = make_terrain(kind, 65);
    for (int row = 0; row < 17; ++row)
      for (int column = 0; column < 17; ++column)
        // Positions differ by rounding, which slopes below 10 turn into less than this.
        CHECK(std::abs(coarse.height_m(column, row) - fine.height_m(4 * column, 4 * row)) <= 1e-3);
  }
}

TEST_CASE("noise tells its own slope") {
  for (int i = 0; i < 200; ++i) {
    const Vec2 at{0.37 * i - 31.1, 0.211 * i - 17.7};
    constexpr double step = 1e-5;
    const auto rise = [&](auto noise, Vec2 direction) {
      return (noise(at + step * direction).value - noise(at - step * direction).value) / (2 * step);
    };
    const auto check = [&](auto noise) {
      const Sloped here = noise(at);
      // Second order in the step, with curvatures of a few hundred.
      CHECK(std::abs(rise(noise, {1, 0}) - here.slope.x) <= 1e-5);
      CHECK(std::abs(rise(noise, {0, 1}) - here.slope.y) <= 1e-5);
    };
    check([](Vec2 p) { return gradient_noise(p, 3); });
    check([](Vec2 p) { return fractal_noise(p, 3, 4, 0.5); });
    CHECK(std::abs(gradient_noise(at, 3).value) <= 1.5);
  }
}

} // namespace orograph::samples_test
