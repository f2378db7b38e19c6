// SPDX-License-Identifier: GPL-3.0-or-later
// Rasters that are read in larger cells are those of all their heights.
#include "dem/levels/generalise.hpp"
#include "dem/levels/part_of_grid.hpp"
#include "dem/levels/stretched_lattice.hpp"
#include "dem/read/raster_parts.hpp"
#include "tests/catch.hpp"
#include "tests/dem/read/cut_raster.hpp"
#include "tests/dem/read/read_back.hpp"
#include "tests/dem/read/refused.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <cpl_string.h>
#include <gdal_priv.h>

#include <cmath>
#include <cstring>
#include <variant>

#include "gdal/gdal.hpp"

namespace orograph::large_rasters_test {
namespace {

// Of smooth hills, so that no neighbours are as high, but for voids.
RasterFile random_raster(Random& random) {
  RasterFile raster = counting_raster(random.whole(20, 120), random.whole(20, 120));
  for (std::size_t i = 0; i < raster.values.size(); ++i)
    raster.values[i] = random.chance(0.02)
                           ? -9999
                           : 500 * std::sin(0.01 * static_cast<double>(i)) + random.between(0, 50);
  raster.nodata = -9999;
  raster.geotransform = {5000, 30, 0, 7000, 0, -20};
  if (random.chance(0.3)) raster = south_up(raster);
  if (random.chance(0.3)) raster = transposed(raster);
  if (random.chance(0.5)) raster.creation_options = {"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16"};
  return raster;
}

void check_same(const TerrainData& read, const TerrainData& whole, int step) {
  REQUIRE(read.larger_cells);
  CHECK(read.larger_cells->step == step);
  const Grid &a = grid_of(read), &file = grid_of(whole);
  const Grid b = generalised(file, step, [](int, int) { return false; });
  REQUIRE(a.columns == b.columns);
  REQUIRE(a.rows == b.rows);
  const auto &made = std::get<Heights<float>>(a.heights_m),
             &of = std::get<Heights<float>>(b.heights_m);
  CHECK(std::memcmp(made.data(), of.data(), made.size() * sizeof(float)) == 0);
  CHECK(a.plane().position_m(a.columns - 1, a.rows - 1) ==
        b.plane().position_m(b.columns - 1, b.rows - 1));
  CHECK(read.larger_cells->columns == file.columns);
  CHECK(read.larger_cells->rows == file.rows);
  CHECK(read.surface_error_m == read.larger_cells->departure.greatest_m);
}

} // namespace

TEST_CASE("a large raster, or a window of it, is read in larger cells of all its heights") {
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const TempFolder folder;
    const std::string path = folder.file("dem.tif");
    const RasterFile raster = random_raster(random);
    write_raster(raster, path);
    ReadOptions options;
    if (random.chance(0.4)) options.bbox = Box2{{5100, 6500}, {5450, 6900}};
    TerrainData whole;
    try {
      whole = read_raster(path, options);
    } catch (const Error&) {
      continue; // the window holds nothing of it
    }
    const Grid& file = grid_of(whole);
    const int shorter = std::min(file.columns, file.rows) - 1, step = random.pick({2, 4});
    if (shorter / step < 3) continue;
    options.large = LargeRasters{10, shorter / step};
    double told = 0;
    const TerrainData read = read_rasters({path}, options, [&](double share) {
      CHECK(share > told);
      told = share;
    });
    CHECK(told == 1);
    check_same(read, whole, step);
    // Parts of it in its own cells.
    std::vector<GridPart> parts;
    for (int i = 0; i < 3; ++i) {
      GridPart part{random.whole(0, file.columns - 2), random.whole(0, file.rows - 2), 0, 0};
      part.columns = random.whole(2, file.columns - part.first_column);
      part.rows = random.whole(2, file.rows - part.first_row);
      parts.push_back(part);
    }
    const std::vector<RasterPart> own = read_raster_parts({path}, options, parts);
    REQUIRE(own.size() == parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto& made = std::get<Heights<float>>(own[i].cells.heights_m);
      const Grid wanted = part_of_grid(file, parts[i]);
      const auto& of = std::get<Heights<float>>(wanted.heights_m);
      REQUIRE(made.size() == of.size());
      CHECK(std::memcmp(made.data(), of.data(), made.size() * sizeof(float)) == 0);
    }
    options.max_memory = 10;
    CHECK_THROWS_AS(read_raster_parts({path}, options, parts), Error);
  }
}

TEST_CASE("tiles that are joined are read in larger cells, with the notes that they have") {
  Random random(7);
  const TempFolder folder;
  RasterFile raster = random_raster(random);
  raster = counting_raster(80, 60);
  for (double& value : raster.values) value = random.between(0, 900);
  write_raster(cut_from(raster, 0, 0, 45, 60), folder.file("west.tif"));
  RasterFile east = cut_from(raster, 40, 0, 40, 60);
  east.values[2] += 5; // a height that the other file has, too
  write_raster(east, folder.file("east.tif"));
  const std::vector<std::string> paths{folder.file("west.tif"), folder.file("east.tif")};
  ReadOptions options;
  const TerrainData whole = read_rasters(paths, options);
  options.large = LargeRasters{10, 14};
  const TerrainData read = read_rasters(paths, options);
  check_same(read, whole, 4);
  CHECK(read.notes == whole.notes);
  CHECK(!read.notes.empty());
}

TEST_CASE("rasters that aren't large, or whose voids are filled, are read as they are") {
  const TempFolder folder;
  RasterFile raster = counting_raster(40, 40);
  raster.values[3] = -1;
  raster.nodata = -1;
  write_raster(raster, folder.file("dem.tif"));
  ReadOptions options;
  options.large = LargeRasters{1600, 5};
  CHECK(!read_raster(folder.file("dem.tif"), options).larger_cells);
  options.large->most_heights = 1599;
  CHECK(read_raster(folder.file("dem.tif"), options).larger_cells);
  options.fill_voids = 3;
  CHECK(!read_raster(folder.file("dem.tif"), options).larger_cells);
}

TEST_CASE("a raster that would take more memory than it may is refused before it is read") {
  const TempFolder folder;
  write_raster(counting_raster(1000, 500), folder.file("dem.tif"));
  ReadOptions options;
  options.max_memory = 3'999'999;
  const std::string message = message_of(folder.file("dem.tif"), options);
  CHECK(message.find("1000 x 500 heights") != std::string::npos);
  CHECK(message.find("`max_memory`") != std::string::npos);
  options.max_memory = 4'000'000; // heights of 4 bytes, and as much to draw them
  CHECK(grid_of(read_raster(folder.file("dem.tif"), options)).size() == 500'000);
}

// A TIFF of 447 bytes told of 16,385 bands, of which GDAL takes 4.3 GB to read a row of 65,535.
TEST_CASE("bands side by side, of which a block takes more memory than it may, are refused") {
  const TempFolder folder;
  const std::string path = folder.file("bands.tif");
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  CPLStringList layout;
  layout.SetNameValue("INTERLEAVE", "PIXEL");
  for (const char* const option : {"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16"})
    layout.AddString(option);
  Dataset(driver->Create(path.c_str(), 10, 10, 100, GDT_Float32, layout.List()));
  ReadOptions options;
  options.max_memory = 102'399;
  const std::string message = message_of(path, options);
  CHECK(message.find("bands side by side") != std::string::npos);
  CHECK(message.find("gdal_translate -b 1") != std::string::npos);
  options.max_memory = 102'400; // 16 x 16 pixels, 100 bands, 4 bytes
  CHECK(grid_of(read_raster(path, options)).size() == 100);
}

} // namespace orograph::large_rasters_test
