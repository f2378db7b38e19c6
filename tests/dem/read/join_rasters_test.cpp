// SPDX-License-Identifier: GPL-3.0-or-later
// Tiles cut from a raster and joined again are the raster, to the last bit.
#include "dem/read/crs_frame.hpp"
#include "tests/catch.hpp"
#include "tests/dem/read/cut_raster.hpp"
#include "tests/dem/read/read_back.hpp"
#include "tests/dem/read/refused.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <fmt/format.h>
#include <gdal_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace orograph::join_rasters_test {
namespace {

using Limits = std::numeric_limits<double>;
const double kNodata = -32768;

// Whole heights, so that every type of tile holds them, with voids.
RasterFile random_raster(Random& random) {
  RasterFile raster = counting_raster(random.whole(4, 40), random.whole(4, 40));
  for (double& value : raster.values)
    value = random.chance(0.05) ? kNodata : random.whole(-100, 4000);
  raster.nodata = kNodata;
  raster.geotransform = {random.whole(-9, 9) * 1000. + 5, 30, 0,
                         random.whole(0, 9) * 1000.,      0,  -20};
  return raster;
}

// Where to cut an axis: the first and the count of each part. With `shared` neighbours have one
// row in common, as SRTM's have.
std::vector<std::pair<int, int>> cuts(Random& random, int count, bool shared) {
  std::set<int> at{0, count};
  for (int i = random.whole(0, 3); i > 0; --i) at.insert(random.whole(1, count - 1));
  std::vector<std::pair<int, int>> parts;
  for (auto from = at.begin(); std::next(from) != at.end(); ++from) {
    const int end = std::min(count, *std::next(from) + (shared ? 1 : 0));
    parts.emplace_back(*from, end - *from);
  }
  return parts;
}

std::vector<RasterFile> random_tiles(Random& random, const RasterFile& whole) {
  std::vector<RasterFile> tiles;
  const bool shared = random.chance(0.5);
  for (const auto& [pixel, pixels] : cuts(random, whole.pixels, shared))
    for (const auto& [line, lines] : cuts(random, whole.lines, shared))
      tiles.push_back(cut_from(whole, pixel, line, pixels, lines));
  if (random.chance(0.4)) { // over each other
    const int line = random.whole(0, whole.lines - 1), pixel = random.whole(0, whole.pixels - 1);
    tiles.push_back(cut_from(whole, 0, line, whole.pixels, whole.lines - line));
    tiles.push_back(cut_from(whole, pixel, 0, whole.pixels - pixel, whole.lines));
  }
  for (std::size_t i = tiles.size(); i > 1; --i)
    std::swap(tiles[i - 1],
              tiles[static_cast<std::size_t>(random.whole(0, static_cast<int>(i) - 1))]);
  for (RasterFile& tile : tiles) {
    if (random.chance(0.3)) tile = south_up(tile);
    if (random.chance(0.3)) tile = transposed(tile);
    tile.type = random.pick<std::string>({"Int16", "Float32"});
  }
  return tiles;
}

std::vector<std::string> written(const TempFolder& folder, const std::vector<RasterFile>& tiles) {
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    paths.push_back(folder.file(fmt::format("tile{}.tif", i)));
    write_raster(tiles[i], paths.back());
  }
  return paths;
}

template <class Height>
bool same_bits(const Heights<Height>& a, const Heights<Height>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](Height x, Height y) {
           return x == y || (std::isnan(x) && std::isnan(y));
         });
}

void check_same(const TerrainData& joined, const TerrainData& whole) {
  const Grid &a = grid_of(joined), &b = grid_of(whole);
  REQUIRE(a.columns == b.columns);
  REQUIRE(a.rows == b.rows);
  CHECK(joined.map.origin == whole.map.origin);
  CHECK(joined.map.unit_m == whole.map.unit_m);
  CHECK(same_place(joined.map.crs_wkt, whole.map.crs_wkt));
  REQUIRE(joined.map.radii.has_value() == whole.map.radii.has_value());
  if (whole.map.radii) {
    CHECK(joined.map.radii->meridian_m == whole.map.radii->meridian_m);
    CHECK(joined.map.radii->prime_vertical_m == whole.map.radii->prime_vertical_m);
  }
  for (const int column : {0, 1, a.columns - 1})
    for (const int row : {0, 1, a.rows - 1})
      CHECK(a.plane().position_m(column, row) == b.plane().position_m(column, row));
  REQUIRE(a.heights_m.index() == b.heights_m.index());
  CHECK(std::visit(
      [&](const auto& heights) {
        return same_bits(heights, std::get<std::decay_t<decltype(heights)>>(b.heights_m));
      },
      a.heights_m));
}

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

void check_degrees(const TerrainData& terrain, int west, int north, int columns, int rows) {
  const Grid& grid = grid_of(terrain);
  REQUIRE(grid.columns == columns);
  REQUIRE(grid.rows == rows);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      CHECK(grid.height_m(column, row) == height_at_degree(west + column, north - row));
}

} // namespace

TEST_CASE("tiles cut at random are the raster that they were cut from") {
  Random random(1);
  for (int i = 0; i < rounds(60); ++i) {
    const TempFolder folder;
    RasterFile whole = random_raster(random);
    std::vector<RasterFile> tiles = random_tiles(random, whole);
    if (random.chance(0.3)) { // one tile in double makes all of it so
      whole.type = "Float64";
      tiles[static_cast<std::size_t>(random.whole(0, static_cast<int>(tiles.size()) - 1))].type =
          random.pick<std::string>({"Float64", "Int32"});
    }
    write_raster(whole, folder.file("whole.tif"));
    const std::vector<std::string> paths = written(folder, tiles);
    ReadOptions options;
    if (random.chance(0.5)) {
      const auto& gt = *whole.geotransform;
      const int pixel = random.whole(0, whole.pixels - 2), line = random.whole(0, whole.lines - 2);
      options.bbox = Box2{{gt[0] + 30 * pixel, gt[3] - 20 * random.whole(line + 2, whole.lines)},
                          {gt[0] + 30 * random.whole(pixel + 2, whole.pixels), gt[3] - 20 * line}};
    }
    if (random.chance(0.5)) options.fill_voids = random.pick({1.0, 2.5, 100.0});
    INFO("run " << i);
    if (!message_of(folder.file("whole.tif"), options).empty()) { // a window of voids
      CHECK(!message_of_all(paths, options).empty());
      continue;
    }
    const TerrainData joined = read_terrain(paths, options);
    check_same(joined, read_raster(folder.file("whole.tif"), options));
    CHECK(!has_note(joined, "differ"));
    CHECK(joined.paths == paths);
  }
}

TEST_CASE("where no tile is there is no height; the first file that has one is taken") {
  Random random(2);
  for (int i = 0; i < 30; ++i) {
    const TempFolder folder;
    const int columns = random.whole(3, 12), rows = random.whole(3, 12);
    RasterFile ground = counting_raster(columns, rows);
    ground.nodata = -1;
    std::vector<RasterFile> tiles;
    std::vector<double> expected(ground.values.size(), Limits::quiet_NaN());
    std::size_t differing = 0;
    double greatest = 0;
    for (int t = random.whole(2, 6); t > 0; --t) {
      int pixel = random.whole(0, columns - 1), line = random.whole(0, rows - 1);
      int pixels = random.whole(1, columns - pixel), lines = random.whole(1, rows - line);
      if (tiles.empty()) { // holds the middle, so that all of these touch
        pixel = line = 0;
        pixels = columns;
        lines = rows;
      }
      RasterFile tile = cut_from(ground, pixel, line, pixels, lines);
      for (std::size_t k = 0; k < tile.values.size(); ++k) {
        tile.values[k] = random.chance(0.4) ? -1 : random.whole(0, 3);
        double& there =
            expected[static_cast<std::size_t>((line + static_cast<int>(k) / pixels) * columns +
                                              pixel + static_cast<int>(k) % pixels)];
        if (tile.values[k] == -1) continue;
        if (std::isnan(there)) {
          there = tile.values[k];
        } else if (there != tile.values[k]) {
          ++differing;
          greatest = std::max(greatest, std::abs(there - tile.values[k]));
        }
      }
      tiles.push_back(tile);
    }
    if (std::all_of(expected.begin(), expected.end(), [](double h) { return std::isnan(h); }))
      continue;
    const TerrainData joined = read_terrain(written(folder, tiles));
    const Grid& grid = grid_of(joined);
    REQUIRE(grid.size() == expected.size());
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        const double wanted = expected[grid.index(column, row)], is = grid.height_m(column, row);
        CHECK((is == wanted || (std::isnan(is) && std::isnan(wanted))));
      }
    CHECK(has_note(joined, "differ") == (differing > 0));
    if (differing > 0)
      CHECK(has_note(joined,
                     fmt::format("overlap {} heights differ, by up to {} m", differing, greatest)));
  }
}

TEST_CASE("three tiles around a corner leave the fourth empty") {
  const TempFolder folder;
  const RasterFile whole = counting_raster(6, 4);
  const TerrainData joined =
      read_terrain(written(folder, {cut_from(whole, 0, 2, 3, 2), cut_from(whole, 3, 0, 3, 2),
                                    cut_from(whole, 3, 2, 3, 2)}));
  const Grid& grid = grid_of(joined);
  REQUIRE(grid.columns == 6);
  REQUIRE(grid.rows == 4);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 6; ++column) {
      if (column < 3 && row < 2)
        CHECK(std::isnan(grid.height_m(column, row)));
      else
        CHECK(grid.height_m(column, row) == 6 * row + column);
    }
}

TEST_CASE("heights in different units are joined in metres, and voids are filled across seams") {
  const TempFolder folder;
  RasterFile whole = counting_raster(8, 4);
  RasterFile west = cut_from(whole, 0, 0, 4, 4), east = cut_from(whole, 4, 0, 4, 4);
  for (double& value : west.values) value = 100;
  for (double& value : east.values) value = 1000;
  east.unit = "dm";
  east.nodata = 7;
  for (int line = 0; line < 4; ++line) east.values[static_cast<std::size_t>(4 * line)] = 7;
  const std::vector<std::string> paths = written(folder, {west, east});
  CHECK(std::isnan(grid_of(read_terrain(paths)).height_m(4, 1)));
  ReadOptions options;
  options.fill_voids = 3;
  const TerrainData joined = read_terrain(paths, options);
  for (int column = 0; column < 8; ++column)
    CHECK(grid_of(joined).height_m(column, 1) == Approx(100).epsilon(1e-6));
  CHECK(has_note(joined, "4 missing heights were filled"));
}

TEST_CASE("overviews of files whose size they divide are joined; others are refused") {
  const TempFolder folder;
  RasterFile whole = counting_raster(32, 16);
  whole.overviews = {2};
  ReadOptions options;
  options.overview = 0;
  const RasterFile west = cut_from(whole, 0, 0, 16, 16), east = cut_from(whole, 16, 0, 16, 16);
  write_raster(whole, folder.file("whole.tif"));
  check_same(read_terrain(written(folder, {east, west}), options),
             read_raster(folder.file("whole.tif"), options));
  const RasterFile odd_west = cut_from(whole, 0, 0, 15, 16), odd = cut_from(whole, 15, 0, 17, 16);
  check_message(message_of_all(written(folder, {odd_west, odd}), options),
                {"tile0.tif", "tile1.tif", "overview", "one lattice", "leave `overview` out"});
}

TEST_CASE("a VRT of two sources is one input") {
  const TempFolder folder;
  RasterFile whole = counting_raster(9, 5);
  whole.type = "Int16";
  write_raster(whole, folder.file("whole.tif"));
  const std::vector<std::string> paths =
      written(folder, {cut_from(whole, 0, 0, 5, 5), cut_from(whole, 4, 0, 5, 5)});
  const std::vector<const char*> names{paths[0].c_str(), paths[1].c_str()};
  GDALClose(
      GDALBuildVRT(folder.file("all.vrt").c_str(), 2, nullptr, names.data(), nullptr, nullptr));
  check_same(read_terrain(folder.file("all.vrt")), read_raster(folder.file("whole.tif")));
  check_same(read_terrain({folder.file("all.vrt"), paths[1]}),
             read_raster(folder.file("whole.tif")));
}

TEST_CASE("notes of several files are told once, with their names where they aren't of all") {
  const TempFolder folder;
  RasterFile whole = counting_raster(9, 5);
  std::vector<RasterFile> tiles{cut_from(whole, 0, 0, 3, 5), cut_from(whole, 3, 0, 3, 5),
                                cut_from(whole, 6, 0, 3, 5)};
  for (RasterFile& tile : tiles) tile.unit.clear();
  CHECK(read_terrain(written(folder, tiles)).notes ==
        std::vector<std::string>{"The file names no unit of height: metres are taken."});
  tiles[0].unit = "m";
  const TerrainData joined = read_terrain(written(folder, tiles));
  CHECK(joined.notes == std::vector<std::string>{folder.file("tile1.tif") +
                                                 " and 1 more: The file names no unit of height: "
                                                 "metres are taken."});
}

// Files in degrees: across 180 degrees, and in either counting of longitudes.

TEST_CASE("tiles on both sides of 180 degrees are one terrain") {
  const TempFolder folder;
  const std::vector<std::string> paths{folder.file("w180.tif"), folder.file("e170.tif")};
  for (const int shared : {0, 1}) {
    write_raster(degrees_raster(-180, 50, 10, 8), paths[0]);
    write_raster(degrees_raster(170, 50, 10 + shared, 8), paths[1]);
    const TerrainData joined = read_terrain(paths);
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

} // namespace orograph::join_rasters_test
