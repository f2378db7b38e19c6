// SPDX-License-Identifier: GPL-3.0-or-later
// Files large enough to be read in shares and early: every height where it belongs, with one core
// and with several, and the same errors and notes.
#include "dem/read/read_raster.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/dem/read/raster_file.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/support/grid_of.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace orograph::raster_shares_test {
namespace {

constexpr int kPixels = 1300, kLines = 2100; // three shares

// A raw value of each place, in all 16 bits and never the same along a row or column.
double raw(int pixel, int line) {
  return (pixel * 31 + line * 17) % 30011;
}

RasterFile large_raster() {
  RasterFile raster = counting_raster(kPixels, kLines);
  for (int line = 0; line < kLines; ++line)
    for (int pixel = 0; pixel < kPixels; ++pixel)
      raster.values[static_cast<std::size_t>(line) * kPixels + static_cast<std::size_t>(pixel)] =
          raw(pixel, line);
  return raster;
}

TerrainData read_by(int cores, const std::string& path, const ReadOptions& options = {}) {
  const tbb::global_control workers(tbb::global_control::max_allowed_parallelism, 3);
  TerrainData terrain;
  tbb::task_arena(cores).execute([&] { terrain = read_raster(path, options); });
  return terrain;
}

// With one core and with three, `height_m(pixel, line)` at all vertices of the window.
void check_heights(const RasterFile& raster, const std::function<double(int, int)>& height_m,
                   const ReadOptions& options = {}, int first_pixel = 0, int first_line = 0) {
  const TempFolder folder;
  write_raster(raster, folder.file("dem.tif"));
  for (const int cores : {1, 3}) {
    const TerrainData terrain = read_by(cores, folder.file("dem.tif"), options);
    const Grid& grid = grid_of(terrain);
    int wrong = 0;
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        const double wanted = height_m(first_pixel + column, first_line + row);
        const double found = grid.height_m(column, row);
        wrong += !(found == wanted || (std::isnan(found) && std::isnan(wanted)));
      }
    CHECK(wrong == 0);
  }
}

std::string message_of(int cores, const std::string& path) {
  try {
    read_by(cores, path);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("large GeoTIFFs of every layout give each height at its place", "[unsanitized]") {
  const std::vector<std::vector<std::string>> layouts{
      {},
      {"ENDIANNESS=BIG"},
      {"TILED=YES"},
      {"COMPRESS=DEFLATE", "BLOCKYSIZE=37"},
      {"BLOCKYSIZE=2100"},
      {"BIGTIFF=YES", "BLOCKYSIZE=1000"},
  };
  for (const auto& layout : layouts) {
    RasterFile raster = large_raster();
    raster.creation_options = layout;
    INFO((layout.empty() ? "plain" : layout.front()));
    check_heights(raster, raw);
  }
  for (const char* type : {"Int16", "Float64"})
    for (const char* interleave : {"INTERLEAVE=PIXEL", "INTERLEAVE=BAND"}) {
      RasterFile raster = large_raster();
      raster.type = type;
      raster.bands = 2;
      raster.creation_options = {interleave};
      INFO(type << " " << interleave);
      ReadOptions second;
      second.band = 2;
      check_heights(raster, raw, second);
    }
}

TEST_CASE("large GeoTIFFs: nodata, scale and offset, and units that only the CRS tells") {
  RasterFile raster = large_raster();
  raster.nodata = 1234;
  raster.scale = 0.5;
  raster.offset = -100;
  check_heights(raster, [](int pixel, int line) {
    const double value = raw(pixel, line);
    return value == 1234 ? std::nan("") : static_cast<double>(static_cast<float>(value / 2 - 100));
  });

  raster = large_raster();
  raster.crs = "EPSG:32632+6360"; // heights in US survey feet
  raster.unit = "";
  check_heights(raster, [](int pixel, int line) {
    return static_cast<double>(static_cast<float>(raw(pixel, line) * (1200. / 3937)));
  });
}

TEST_CASE("large GeoTIFFs: windows, and rows that run north") {
  // Cells of 10 m from (500000, 5000000): vertices 100 to 1199 of rows 333 to 1999.
  ReadOptions options;
  options.bbox = Box2{{501000, 4980000}, {512000, 4996670}};
  check_heights(large_raster(), raw, options, 100, 333);

  RasterFile raster = large_raster();
  raster.geotransform = {500000, 10, 0, 5000000, 0, 10};
  check_heights(raster, [](int pixel, int line) { return raw(pixel, kLines - 1 - line); });
}

TEST_CASE("a large GeoTIFF that is cut off is refused in the same words on any number of cores") {
  const TempFolder folder;
  for (const char* layout : {"TILED=NO", "TILED=YES", "COMPRESS=DEFLATE"}) {
    RasterFile raster = large_raster();
    raster.creation_options = {layout};
    const std::string path = folder.file("dem.tif");
    write_raster(raster, path);
    std::filesystem::resize_file(path, std::filesystem::file_size(path) * 2 / 3);
    INFO(layout);
    const std::string message = message_of(1, path);
    // What libtiff says of the first block that is missing, not what another way of reading says.
    CHECK(message.find("dem.tif, band 1: IReadBlock failed") != message.npos);
    CHECK(message_of(3, path) == message);
  }
}

TEST_CASE("a large GeoTIFF of which parts were never written says so") {
  const TempFolder folder;
  RasterFile raster = counting_raster(kPixels, kLines);
  raster.values.clear();
  raster.creation_options = {"SPARSE_OK=TRUE"};
  for (const bool nodata : {false, true}) {
    if (nodata) raster.nodata = 7;
    write_raster(raster, folder.file("dem.tif"));
    for (const int cores : {1, 3}) {
      if (nodata) {
        CHECK(message_of(cores, folder.file("dem.tif")).find("nodata only") != std::string::npos);
        continue;
      }
      const TerrainData terrain = read_by(cores, folder.file("dem.tif"));
      CHECK(std::ranges::count_if(terrain.notes, [](const std::string& note) {
              return note.find("never written") != note.npos;
            }) == 1);
    }
  }
}

} // namespace orograph::raster_shares_test
