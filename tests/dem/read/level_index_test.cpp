// SPDX-License-Identifier: GPL-3.0-or-later
// An index beside a raster gives what the raster gives, or nothing.
#include "dem/levels/nested_cells.hpp"
#include "dem/read/level_index.hpp"
#include "dem/read/raster_bands.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/dem/read/raster_file.hpp"
#include "tests/dem/read/read_back.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace orograph::level_index_test {
namespace {

constexpr int kPixels = 530, kLines = 520; // of which one level is indexed

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

struct Indexed {
  TempFolder folder;
  std::string path = folder.file("dem.tif");
  ReadOptions options;

  Indexed() {
    options.large = LargeRasters{1000, 129, true};
    Random random(3);
    RasterFile raster = counting_raster(kPixels, kLines);
    for (double& value : raster.values) value = random.chance(0.01) ? -1 : random.between(0, 900);
    raster.nodata = -1;
    write_raster(raster, path);
    const RasterIndex made = index_of({path}, options);
    write_index(index_path({path}), made.state, made.levels);
  }
  TerrainData read(bool use_index) {
    options.use_index = use_index;
    return read_raster(path, options);
  }
};

template <class Value>
bool have_same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

bool are_same(const NestedCells& a, const NestedCells& b) {
  bool same = have_same_bits(a.ranges, b.ranges) && a.departures.size() == b.departures.size() &&
              a.heights.size() == b.heights.size();
  for (std::size_t i = 0; same && i < a.departures.size(); ++i)
    same = have_same_bits(a.departures[i], b.departures[i]);
  for (std::size_t i = 0; same && i < a.heights.size(); ++i)
    same = have_same_bits(std::get<std::vector<float>>(a.heights[i]),
                          std::get<std::vector<float>>(b.heights[i]));
  return same;
}

bool are_same(const TerrainData& a, const TerrainData& b) {
  const auto &of_a = std::get<Heights<float>>(grid_of(a).heights_m),
             &of_b = std::get<Heights<float>>(grid_of(b).heights_m);
  return of_a.size() == of_b.size() &&
         std::memcmp(of_a.data(), of_b.data(), of_a.size() * sizeof(float)) == 0 &&
         a.larger_cells->tops == b.larger_cells->tops &&
         a.larger_cells->departure.greatest_m == b.larger_cells->departure.greatest_m &&
         a.larger_cells->departure.rms_m == b.larger_cells->departure.rms_m &&
         a.surface_error_m == b.surface_error_m &&
         are_same(*a.larger_cells->nested, *b.larger_cells->nested);
}

} // namespace

TEST_CASE("from an index comes what the raster gives, and nothing is said") {
  Indexed files;
  const TerrainData from_file = files.read(false), from_index = files.read(true);
  CHECK(are_same(from_file, from_index));
  CHECK(from_index.doubts.empty());
  // It is the index that is read: with other heights in it, and their sum, these come.
  const RasterIndex made = index_of({files.path}, files.options);
  std::vector<IndexedLevel> other = made.levels;
  std::get<std::vector<float>>(other.front().heights)
      .assign(std::get<std::vector<float>>(other.front().heights).size(), 7.F);
  write_index(index_path({files.path}), made.state, other);
  CHECK(grid_of(files.read(true)).height_m(3, 4) == 7);
  CHECK(grid_of(files.read(false)).height_m(3, 4) != 7);
}

TEST_CASE("an index that is damaged anywhere is left aside with a word") {
  Indexed files;
  const TerrainData from_file = files.read(false);
  const std::string path = index_path({files.path}), whole = bytes_of(path);
  Random random(11);
  const auto check_left_aside = [&](const std::string& bytes) {
    write_bytes(path, bytes);
    const TerrainData read = files.read(true);
    CHECK(are_same(read, from_file));
    REQUIRE(read.doubts.size() == 1);
    CHECK(read.doubts[0].find(path + " isn't used: ") == 0);
  };
  const int flips = rounds(60);
  for (int i = 0; i < flips; ++i) {
    const int place =
        i < flips / 2 ? i * 120 / flips : random.whole(60, static_cast<int>(whole.size()) - 1);
    INFO("byte " << place);
    std::string bytes = whole;
    bytes[static_cast<std::size_t>(place)] =
        static_cast<char>(bytes[static_cast<std::size_t>(place)] ^ (1 << random.whole(0, 7)));
    check_left_aside(bytes);
  }
  for (const std::size_t size :
       {whole.size() - 1, whole.size() / 2, std::size_t{30}, std::size_t{9}}) {
    INFO("of " << size << " bytes");
    check_left_aside(whole.substr(0, size));
  }
  check_left_aside(whole + "and more");
}

TEST_CASE("an index of other heights is left aside") {
  Indexed files;
  SECTION("the raster was changed since") {
    std::filesystem::last_write_time(files.path, std::filesystem::last_write_time(files.path) +
                                                     std::chrono::seconds(2));
  }
  SECTION("another unit of heights is asked for") {
    files.options.height_unit = "ft";
  }
  const TerrainData from_file = files.read(false), read = files.read(true);
  CHECK(are_same(read, from_file));
  REQUIRE(read.doubts.size() == 1);
  CHECK(read.doubts[0].find("changed") != std::string::npos);
}

TEST_CASE("a window is read from the raster, whatever the index holds") {
  Indexed files;
  files.options.bbox = Box2{{500000, 4996000}, {503000, 5000000}};
  const TerrainData read = files.read(true);
  CHECK(read.doubts.empty());
  CHECK(are_same(read, files.read(false)));
}

TEST_CASE("a raster has no index of a part, or where it is small") {
  Indexed files;
  write_raster(counting_raster(500, 511), files.folder.file("small.tif"));
  CHECK_THROWS_AS(index_of({files.folder.file("small.tif")}, {}), Error);
  files.options.bbox = Box2{{500000, 4996000}, {503000, 5000000}};
  CHECK_THROWS_AS(index_of({files.path}, files.options), Error);
}

} // namespace orograph::level_index_test
