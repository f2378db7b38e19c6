// SPDX-License-Identifier: GPL-3.0-or-later
// Parts and overviews of rasters.
#include "tests/catch.hpp"
#include "tests/dem/read/raster_file.hpp"
#include "tests/dem/read/read_back.hpp"
#include "tests/dem/read/stored_surface.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/support/grid_of.hpp"

#include <cmath>

namespace orograph::read_raster_window_test {
TEST_CASE("a window holds the vertices inside it, border included, in any storage") {
  ReadOptions options;
  options.bbox = Box2{{500015, 4999971}, {500034, 4999990}}; // columns 1 to 2, rows 1 to 3
  for (const Storage how : all_storages()) {
    const StoredSurface surface;
    const TerrainData terrain = read_back(stored(surface, how), options);
    REQUIRE(grid_of(terrain).columns == 2);
    REQUIRE(grid_of(terrain).rows == 3);
    CHECK(terrain.map.origin == surface.position(1, 1));
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 2; ++column)
        CHECK(grid_of(terrain).height_m(column, row) == surface.height(column + 1, row + 1));
  }
}

TEST_CASE("a window of a rotated raster has no heights outside the box") {
  const StoredSurface surface = rotated_surface(30);
  const Box2 box{{500010, 4999965}, {500055, 5000005}};
  ReadOptions options;
  options.bbox = box;
  for (const Storage how : all_storages()) {
    const TerrainData terrain = read_back(stored(surface, how), options);
    int kept = 0, expected = 0;
    for (int row = 0; row < grid_of(terrain).rows; ++row)
      for (int column = 0; column < grid_of(terrain).columns; ++column) {
        const Vec2 ground = grid_of(terrain).plane().position_m(column, row);
        const Vec3 map = terrain.map.to_map({ground.x, ground.y, 0});
        const bool inside =
            map.x >= box.low.x && map.x <= box.high.x && map.y >= box.low.y && map.y <= box.high.y;
        CHECK(std::isnan(grid_of(terrain).height_m(column, row)) == !inside);
        kept += inside;
      }
    for (int row = 0; row < surface.rows; ++row)
      for (int column = 0; column < surface.columns; ++column) {
        const Vec2 p = surface.position(column, row);
        expected += p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
      }
    CHECK(kept == expected);
    CHECK(kept > 10);
  }
}

TEST_CASE("an overview covers the same ground with larger cells") {
  // Sizes that 2 and 4 don't divide: 101 x 67 becomes 51 x 34 and 26 x 17.
  RasterFile raster = counting_raster(101, 67);
  raster.overviews = {2, 4};
  raster.type = "UInt16";
  raster.scale = 0.5;
  raster.offset = 3;
  raster.unit = "ft";
  for (const int level : {0, 1}) {
    ReadOptions options;
    options.overview = level;
    const TerrainData terrain = read_back(raster, options);
    const int columns = level == 0 ? 51 : 26, rows = level == 0 ? 34 : 17;
    REQUIRE(grid_of(terrain).columns == columns);
    REQUIRE(grid_of(terrain).rows == rows);
    const double across = 1010. / columns, down = 670. / rows;
    CHECK(std::abs(grid_of(terrain).plane().column_step_m.x - across) <= 1e-12);
    CHECK(std::abs(grid_of(terrain).plane().row_step_m.y + down) <= 1e-12);
    CHECK(std::abs(terrain.map.origin.x - (500000 + across / 2)) <= 1e-8);
    CHECK(std::abs(terrain.map.origin.y - (5000000 - down / 2)) <= 1e-8);
    // Scale, offset and unit stay those of the full heights; the first cell's value is 0, or a
    // neighbour's within a factor of 4 cells.
    const double raw = (grid_of(terrain).height_m(0, 0) / 0.3048 - 3) / 0.5;
    CHECK(raw >= -1e-4);
    CHECK(raw <= 4 + 4 * 101);
    CHECK(std::abs(raw - std::round(raw)) <= 1e-4);
  }
}

TEST_CASE("a window of an overview") {
  RasterFile raster = counting_raster(100, 60);
  raster.overviews = {2};
  ReadOptions options;
  options.overview = 0;
  options.bbox = Box2{{500100, 4999700}, {500300, 4999900}};
  const TerrainData terrain = read_back(raster, options);
  CHECK(grid_of(terrain).columns == 10);
  CHECK(grid_of(terrain).rows == 10);
  CHECK(terrain.map.origin == Vec2{500110, 4999890});
}

TEST_CASE("a band other than the first") {
  const TempFolder folder;
  RasterFile raster = counting_raster(4, 3);
  raster.bands = 2;
  write_raster(raster, folder.file("dem.tif"));
  ReadOptions options;
  options.band = 2;
  CHECK(grid_of(read_raster(folder.file("dem.tif"), options)).height_m(1, 1) == 5);
}

} // namespace orograph::read_raster_window_test
