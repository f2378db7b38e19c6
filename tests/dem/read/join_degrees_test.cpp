// SPDX-License-Identifier: GPL-3.0-or-later
// Files in degrees: across 180 degrees, and in either counting of longitudes.
#include "tests/catch.hpp"
#include "tests/dem/read/cut_raster.hpp"
#include "tests/dem/read/read_back.hpp"
#include "tests/dem/read/refused.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <cmath>

using namespace orograph;

namespace {

// A height for every whole degree of the earth, the same however longitudes are counted.
double height_at_degree(int longitude, int latitude) {
  return 1000 * (((longitude % 360) + 360) % 360) + 90 + latitude;
}

// Vertices at whole degrees.
RasterFile degrees_raster(int west, int north, int columns, int rows) {
  RasterFile raster = counting_raster(columns, rows);
  raster.crs = "EPSG:4326";
  raster.geotransform = {west - 0.5, 1, 0, north + 0.5, 0, -1};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      raster.values[static_cast<std::size_t>(row * columns + column)] =
          height_at_degree(west + column, north - row);
  return raster;
}

void check_degrees(const Terrain& terrain, int west, int north, int columns, int rows) {
  const Grid& grid = grid_of(terrain);
  REQUIRE(grid.columns == columns);
  REQUIRE(grid.rows == rows);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      CHECK(grid.height_m(column, row) == height_at_degree(west + column, north - row));
}

} // namespace

TEST_CASE("tiles on both sides of 180 degrees are one terrain") {
  const TempFolder folder;
  const std::vector<std::string> paths{folder.file("w180.tif"), folder.file("e170.tif")};
  for (const int shared : {0, 1}) {
    write_raster(degrees_raster(-180, 50, 10, 8), paths[0]);
    write_raster(degrees_raster(170, 50, 10 + shared, 8), paths[1]);
    const Terrain joined = read_terrain(paths);
    check_degrees(joined, 170, 50, 20, 8);
    CHECK(!has_note(joined, "differ"));
    ReadOptions options;
    for (const double turn : {0., 360., -360.}) {
      options.bbox_lonlat = Box2{{175 + turn, 45}, {185 + turn, 49}};
      check_degrees(read_terrain(paths, options), 175, 49, 11, 5);
    }
  }
}

TEST_CASE("windows of a grid of the whole earth, across its ends and not") {
  const TempFolder folder;
  const std::string path = folder.file("earth.tif");
  Random random(6);
  for (const int first : {-180, 0})
    for (const int columns : {360, 361}) {
      write_raster(degrees_raster(first, 60, columns, 5), path);
      for (int run = 0; run < 20; ++run) {
        ReadOptions options;
        const int west = random.whole(-180, 180), width = random.whole(1, 300);
        options.bbox_lonlat = Box2{{west - 0.2, 57}, {west + width + 0.2, 60}};
        INFO("grid from " << first << ", window from " << west << ", wide " << width);
        check_degrees(read_terrain(path, options), west, 60, width + 1, 4);
      }
    }
}

TEST_CASE("a file that counts to 360 and one that counts from -180 are joined") {
  const TempFolder folder;
  const std::vector<std::string> paths{folder.file("a.tif"), folder.file("b.tif")};
  write_raster(degrees_raster(280, 50, 8, 8), paths[0]);
  write_raster(degrees_raster(-72, 50, 8, 8), paths[1]);
  check_degrees(read_terrain(paths), 280, 50, 16, 8);
  ReadOptions options;
  options.bbox_lonlat = Box2{{-74, 44}, {-70, 46}};
  check_degrees(read_terrain(paths, options), -74, 46, 5, 3);
}
