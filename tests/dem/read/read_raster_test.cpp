// SPDX-License-Identifier: GPL-3.0-or-later
// The same surface gives the same grid, whatever the file's order, type, nodata and units.
#include "dem/read/read_raster.hpp"
#include "tests/catch.hpp"
#include "tests/dem/read/raster_file.hpp"
#include "tests/dem/read/read_back.hpp"
#include "tests/dem/read/stored_surface.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/support/grid_of.hpp"

#include <cmath>
#include <filesystem>
#include <limits>

namespace orograph::read_raster_test {
namespace {

// Every vertex where the surface has it (to the rounding of coordinates of 5e6) and as high, but
// for a hole at (3, 2).
void check_surface(const TerrainData& terrain, const StoredSurface& surface,
                   double height_tolerance_m) {
  REQUIRE(grid_of(terrain).columns == surface.columns);
  REQUIRE(grid_of(terrain).rows == surface.rows);
  for (int row = 0; row < surface.rows; ++row)
    for (int column = 0; column < surface.columns; ++column) {
      const Vec2 ground = grid_of(terrain).plane().position_m(column, row);
      const Vec3 map = terrain.map.to_map({ground.x, ground.y, 0});
      CHECK(length(Vec2{map.x, map.y} - surface.position(column, row)) <= 1e-8);
      const double height = grid_of(terrain).height_m(column, row);
      if (column == 3 && row == 2)
        CHECK(std::isnan(height));
      else
        CHECK(std::abs(height - surface.height(column, row)) <= height_tolerance_m);
    }
}

// Raw values from heights, with a hole of `hole`.
RasterFile encoded(const StoredSurface& surface, Storage how, double scale, double offset,
                   double hole) {
  RasterFile raster = stored(surface, how);
  for (double& value : raster.values)
    value = value == surface.height(3, 2) ? hole : std::round((value - offset) / scale);
  return raster;
}

// The surface upright and rotated, in all eight storages.
template <class Check>
void for_all_storages(const Check& check) {
  for (const double angle_deg : {0., 30., -41.})
    for (const Storage how : all_storages()) {
      INFO("angle " << angle_deg << " transposed " << how.transposed);
      check(rotated_surface(angle_deg), how);
    }
}

} // namespace

TEST_CASE("one grid from all storages: Float32 with NaN and no nodata value") {
  for_all_storages([](const StoredSurface& surface, Storage how) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    check_surface(read_back(encoded(surface, how, 1, 0, nan)), surface, 0);
  });
}

TEST_CASE("one grid from all storages: Float32 with an infinite hole") {
  for_all_storages([](const StoredSurface& surface, Storage how) {
    const double infinity = std::numeric_limits<double>::infinity();
    check_surface(read_back(encoded(surface, how, 1, 0, -infinity)), surface, 0);
  });
}

TEST_CASE("one grid from all storages: Int16 with nodata +32767") {
  for_all_storages([](const StoredSurface& surface, Storage how) {
    RasterFile raster = encoded(surface, how, 1, 0, 32767);
    raster.type = "Int16";
    raster.nodata = 32767;
    check_surface(read_back(raster), surface, 0);
  });
}

TEST_CASE("one grid from all storages: UInt16 with scale and offset, raw nodata") {
  for_all_storages([](const StoredSurface& surface, Storage how) {
    RasterFile raster = encoded(surface, how, 0.1, -100, 65535);
    raster.type = "UInt16";
    raster.nodata = 65535;
    raster.scale = 0.1;
    raster.offset = -100;
    // Float's rounding of heights up to 200.
    check_surface(read_back(raster), surface, 1e-5);
  });
}

TEST_CASE("one grid from all storages: Float64") {
  for_all_storages([](const StoredSurface& surface, Storage how) {
    RasterFile raster = encoded(surface, how, 1, 0, -9999);
    raster.type = "Float64";
    raster.nodata = -9999;
    check_surface(read_back(raster), surface, 0);
  });
}

TEST_CASE("nodata at the end of float's range, as written with 15 digits") {
  RasterFile raster = counting_raster(4, 3);
  raster.values[5] = static_cast<double>(std::numeric_limits<float>::lowest());
  raster.nodata = -3.40282346638529e+38;
  const TerrainData terrain = read_back(raster);
  CHECK(std::isnan(grid_of(terrain).height_m(1, 1)));
  CHECK(grid_of(terrain).height_m(2, 1) == 6);
}

TEST_CASE("positions along a row of an upright grid are whole steps, exactly") {
  for (const Storage how : all_storages()) {
    const TerrainData terrain = read_back(stored(StoredSurface{}, how));
    for (int row = 0; row < grid_of(terrain).rows; ++row)
      for (int column = 0; column < grid_of(terrain).columns; ++column)
        CHECK(grid_of(terrain).plane().position_m(column, row) == Vec2{10. * column, -8. * row});
    CHECK(terrain.map.origin == Vec2{500005, 4999995});
  }
}

TEST_CASE("heights are double only where float can't hold the file's") {
  RasterFile raster = counting_raster(4, 3);
  const auto in_double = [&](const char* type) {
    raster.type = type;
    return std::holds_alternative<Heights<double>>(grid_of(read_back(raster)).heights_m);
  };
  for (const char* type : {"Byte", "Int16", "UInt16", "Float32"}) CHECK(!in_double(type));
  for (const char* type : {"Int32", "UInt32", "Float64"}) CHECK(in_double(type));
  raster.values[5] = 16777217; // the first integer that float can't hold
  raster.type = "Int32";
  CHECK(grid_of(read_back(raster)).height_m(1, 1) == 16777217);
}

TEST_CASE("a mask in the file makes gaps as nodata does") {
  RasterFile raster = counting_raster(4, 3);
  raster.bands = 2;
  raster.type = "Byte";
  raster.creation_options = {"ALPHA=YES"};
  const TerrainData terrain =
      read_back(raster); // band 2 holds the same values: 0 at the first vertex
  CHECK(std::isnan(grid_of(terrain).height_m(0, 0)));
  CHECK(grid_of(terrain).height_m(1, 0) == 1);
}

TEST_CASE("any block layout gives the same heights") {
  RasterFile raster = counting_raster(700, 500);
  const auto plain = std::get<Heights<float>>(grid_of(read_back(raster)).heights_m);
  REQUIRE(plain.size() == 350000);
  CHECK(plain[123456] == 123456);
  for (const std::vector<std::string>& layout :
       {std::vector<std::string>{"TILED=YES", "BLOCKXSIZE=128", "BLOCKYSIZE=64"},
        {"TILED=YES", "BLOCKXSIZE=1024", "BLOCKYSIZE=1024"},
        {"BLOCKYSIZE=500", "COMPRESS=DEFLATE"},
        {"BLOCKYSIZE=7"}}) {
    raster.creation_options = layout;
    CHECK(std::get<Heights<float>>(grid_of(read_back(raster)).heights_m) == plain);
    ReadOptions part;
    part.bbox = Box2{{500995, 4996995}, {505005, 4999005}};
    const TerrainData window = read_back(raster, part);
    CHECK(grid_of(window).columns == 402);
    CHECK(grid_of(window).rows == 202);
    CHECK(grid_of(window).height_m(0, 0) == 99 * 700 + 99);
    CHECK(grid_of(window).height_m(401, 201) == 300 * 700 + 500);
  }
}

TEST_CASE("reading leaves nothing beside the file") {
  const TempFolder folder;
  write_raster(counting_raster(4, 3), folder.file("dem.tif"));
  read_raster(folder.file("dem.tif"));
  int files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path()))
    ++files;
  CHECK(files == 1);
}

TEST_CASE("unwritten parts of a file are told") {
  RasterFile raster = counting_raster(64, 64);
  raster.values.clear();
  raster.creation_options = {"SPARSE_OK=TRUE"};
  CHECK(has_note(read_back(raster), "never written"));
}

} // namespace orograph::read_raster_test
