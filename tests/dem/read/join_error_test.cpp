// SPDX-License-Identifier: GPL-3.0-or-later
// Files that can't be joined, and that the advice in the message is right.
#include "tests/catch.hpp"
#include "tests/dem/read/cut_raster.hpp"
#include "tests/dem/read/read_back.hpp"
#include "tests/dem/read/refused.hpp"
#include "tests/support/grid_of.hpp"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <gdal_utils.h>

#include <cmath>
#include <sstream>

namespace orograph::join_error_test {
namespace {

struct Pair {
  TempFolder folder;
  std::vector<std::string> paths;

  Pair(const RasterFile& a, const RasterFile& b) {
    paths = {folder.file("a.tif"), folder.file("b.tif")};
    write_raster(a, paths[0]);
    write_raster(b, paths[1]);
  }
  std::string refusal(const ReadOptions& options = {}) const {
    return message_of_all(paths, options);
  }
};

RasterFile west_half() {
  return cut_from(counting_raster(12, 6), 0, 0, 6, 6);
}
RasterFile east_half() {
  return cut_from(counting_raster(12, 6), 6, 0, 6, 6);
}

// Does what the message says: "…: gdalwarp OPTIONS b.tif NAME".
std::string warped_as_told(const std::string& message, const Pair& pair) {
  std::istringstream words(message.substr(message.find("gdalwarp ") + 9));
  CPLStringList options;
  std::string word;
  while (words >> word && word != pair.paths[1]) options.AddString(word.c_str());
  CHECK(word == pair.paths[1]);
  const std::string path = pair.folder.file("warped.tif");
  GDALDatasetH source = GDALOpen(pair.paths[1].c_str(), GA_ReadOnly);
  GDALWarpAppOptions* parsed = GDALWarpAppOptionsNew(options.List(), nullptr);
  REQUIRE(parsed != nullptr);
  GDALClose(GDALWarp(path.c_str(), nullptr, 1, &source, parsed, nullptr));
  GDALWarpAppOptionsFree(parsed);
  GDALClose(source);
  return path;
}

} // namespace

TEST_CASE(
    "tiles of another resolution are refused, and the command in the message brings them in") {
  RasterFile fine = counting_raster(13, 9);
  fine.geotransform = {500060, 7, 0, 5000000, 0, -7};
  for (double& value : fine.values) value = 50;
  const Pair pair(west_half(), fine);
  const std::string message = pair.refusal();
  check_message(message, {"a.tif", "b.tif", "cells of 7 x 7", "10 x 10", "gdalwarp", "-tr 10 10"});
  // It has no cell but those that it has heights for: given first, it takes nothing from the other.
  const std::string warped = warped_as_told(message, pair);
  for (const bool first : {true, false}) {
    const TerrainData joined =
        first ? read_terrain({warped, pair.paths[0]}) : read_terrain({pair.paths[0], warped});
    const Grid& grid = grid_of(joined);
    CHECK(grid.columns == 15); // 91 m hold the centres of nine cells
    CHECK(grid.rows == 6);     // 63 m those of six
    for (int column = 0; column < 15; ++column)
      for (int row = 0; row < 6; ++row)
        CHECK(grid.height_m(column, row) == (column < 6 ? 12 * row + column : 50));
  }
}

TEST_CASE("tiles beside the lattice are refused, and the command brings them in") {
  for (const double shift : {0.001, 3.0, -4.9}) {
    RasterFile beside = east_half();
    (*beside.geotransform)[0] += shift;
    const Pair pair(west_half(), beside);
    const std::string message = pair.refusal();
    check_message(message, {"a.tif", "b.tif", "of a cell beside", "gdalwarp"});
    const TerrainData joined =
        read_terrain(std::vector<std::string>{pair.paths[0], warped_as_told(message, pair)});
    CHECK(grid_of(joined).columns == 12);
  }
}

TEST_CASE("what rounding does to a geotransform is no shift") {
  RasterFile rounded = east_half();
  (*rounded.geotransform)[0] += 5e-5;
  (*rounded.geotransform)[1] *= 1 + 1e-9;
  const Pair pair(west_half(), rounded);
  CHECK(pair.refusal() == "");
  CHECK(grid_of(read_terrain(pair.paths)).columns == 12);
}

TEST_CASE("steps that differ by little must lead to the same vertices over the whole tile") {
  RasterFile stretched = east_half();
  (*stretched.geotransform)[1] *= 1 + 3e-6; // 1.5e-5 of a cell after five steps
  check_message(Pair(west_half(), stretched).refusal(), {"b.tif has cells of 10.00003 x 10"});
}

TEST_CASE("tiles that don't touch are refused, by the name of the one that is apart") {
  for (const int gap : {0, 1, 7}) {
    RasterFile apart = east_half();
    (*apart.geotransform)[0] += 10 * gap;
    const Pair pair(west_half(), apart);
    if (gap == 0)
      CHECK(pair.refusal() == "");
    else
      check_message(pair.refusal(), {"b.tif", "doesn't touch"});
  }
  RasterFile corner = east_half();
  (*corner.geotransform)[3] -= 60;
  CHECK(Pair(west_half(), corner).refusal() == "");
  (*corner.geotransform)[3] -= 10;
  check_message(Pair(west_half(), corner).refusal(), {"b.tif", "doesn't touch"});
  // So far that no computer could hold what is between.
  (*corner.geotransform)[3] -= 1e12;
  check_message(Pair(west_half(), corner).refusal(), {"b.tif", "doesn't touch"});

  const TempFolder folder;
  RasterFile whole = counting_raster(12, 6);
  write_raster(cut_from(whole, 0, 0, 2, 6), folder.file("one.tif"));
  write_raster(cut_from(whole, 4, 0, 4, 6), folder.file("two.tif"));
  write_raster(cut_from(whole, 8, 0, 4, 6), folder.file("three.tif"));
  check_message(
      message_of_all({folder.file("one.tif"), folder.file("two.tif"), folder.file("three.tif")}),
      {"one.tif (", "doesn't touch"});
}

TEST_CASE("files of different kinds, CRSs and datums aren't joined") {
  RasterFile other = east_half();
  other.crs = "EPSG:32633";
  check_message(Pair(west_half(), other).refusal(),
                {"a.tif", "b.tif", "UTM zone 32N", "UTM zone 33N", "gdalwarp -t_srs EPSG:32632"});
  other.crs.clear();
  check_message(Pair(west_half(), other).refusal(),
                {"b.tif has no CRS", "gdal_edit.py -a_srs EPSG:32632"});
  RasterFile nowhere = east_half();
  nowhere.geotransform.reset();
  check_message(Pair(west_half(), nowhere).refusal(), {"b.tif has no georeference", "-a_ullr"});

  RasterFile geoid = west_half(), other_geoid = east_half();
  geoid.crs = "EPSG:32632+5773";
  other_geoid.crs = "EPSG:32632+3855";
  check_message(Pair(geoid, other_geoid).refusal(),
                {"a.tif", "b.tif", "EGM96", "EGM2008", "gdalwarp"});
  const Pair half(geoid, east_half());
  CHECK(half.refusal() == "");
  CHECK(has_note(read_terrain(half.paths), "doesn't say what its heights are above: EGM96"));

  const Pair pair(west_half(), east_half());
  write_text(pair.folder.file("points.csv"), "x,y,z\n0,0,1\n1,0,2\n0,1,3\n");
  check_message(message_of_all({pair.paths[0], pair.folder.file("points.csv")}),
                {"points.csv isn't a raster"});
  check_message(message_of_all({pair.folder.file("points.csv"), pair.paths[0]}),
                {"points.csv isn't a raster"});
  check_message(message_of_all({pair.paths[0], pair.folder.file("none.tif")}),
                {"none.tif: no such file"});
}

TEST_CASE("a window of several files") {
  const Pair pair(west_half(), east_half());
  ReadOptions options;
  options.bbox = Box2{{0, 0}, {1, 1}};
  check_message(pair.refusal(options), {"a.tif and 1 more", "holds nothing"});
  options.bbox = Box2{{500050, 4999950}, {500070, 4999970}};
  CHECK(grid_of(read_terrain(pair.paths, options)).columns == 2); // one of either

  // A file that the window leaves out isn't read: its heights may be damaged.
  std::filesystem::resize_file(pair.paths[1], std::filesystem::file_size(pair.paths[1]) - 40);
  CHECK(!pair.refusal(options).empty());
  options.bbox = Box2{{500000, 4999950}, {500040, 4999970}};
  CHECK(pair.refusal(options) == "");
}

TEST_CASE("a tile whose coordinates are too large for its cells is refused for that") {
  RasterFile west = west_half(), east = east_half();
  west.geotransform = {1e17, 10, 0, 5000000, 0, -10};
  east.geotransform = {1e17 + 80, 10, 0, 5000000, 0, -10};
  check_message(Pair(west, east).refusal(),
                {"a.tif", "reach 1e+17", "16 apart", "cells of 10", "gdal_edit.py -a_ullr"});
}

} // namespace orograph::join_error_test
