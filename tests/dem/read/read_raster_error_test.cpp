// SPDX-License-Identifier: GPL-3.0-or-later
// Every way in which a file can't be terrain is told in one line that says what would be right.
#include "dem/read/netcdf_header.hpp"
#include "dem/read/read_raster.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/dem/read/raster_file.hpp"
#include "tests/dem/temp_folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

namespace orograph::read_raster_error_test {
namespace {

// "" if nothing is thrown.
std::string raster_message(const std::string& path, const ReadOptions& options = {}) {
  try {
    read_raster(path, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void check_message(const std::string& message, const std::vector<std::string>& words) {
  INFO(message);
  CHECK(!message.empty());
  CHECK(std::count(message.begin(), message.end(), '\n') == 0);
  for (const std::string& word : words) {
    INFO("should say: " << word);
    CHECK(message.find(word) != std::string::npos);
  }
}

void refused(const RasterFile& raster, const std::vector<std::string>& words,
             const ReadOptions& options = {}) {
  const TempFolder folder;
  write_raster(raster, folder.file("dem.tif"));
  check_message(raster_message(folder.file("dem.tif"), options), words);
}

ReadOptions window(double west, double south, double east, double north) {
  ReadOptions options;
  options.bbox = Box2{{west, south}, {east, north}};
  return options;
}

// In the classic format (docs.unidata.ucar.edu/nug: file format specifications), with `size` rows
// and columns of 4 bytes, of which so many are there.
std::string netcdf(int size, std::size_t heights) {
  std::string out = "CDF\x01";
  const auto number = [&](int n) {
    for (const int shift : {24, 16, 8, 0}) out += static_cast<char>(n >> shift & 255);
  };
  const auto name = [&](const char* letter) {
    number(1);
    out += letter;
    out.append(3, '\0');
  };
  constexpr int kDimensions = 10, kVariables = 11, kFloat = 5;
  for (const int n : {0, kDimensions, 2}) number(n);
  for (const char* dimension : {"y", "x"}) {
    name(dimension);
    number(size);
  }
  for (const int n : {0, 0, kVariables, 1}) number(n);
  name("z");
  for (const int n : {2, 0, 1, 0, 0, kFloat, 4 * size * size, 0}) number(n);
  const auto begin = static_cast<int>(out.size());
  out.resize(out.size() - 4);
  number(begin);
  for (std::size_t i = 0; i < heights; ++i) out += std::string("\x3f\x80\0\0", 4); // 1
  return out;
}

} // namespace

TEST_CASE("netCDF that is cut off is refused, before its heights are read as 0") {
  const TempFolder folder;
  const auto message = [&](int size, std::size_t heights) {
    std::ofstream(folder.file("dem.nc"), std::ios::binary) << netcdf(size, heights);
    return raster_message(folder.file("dem.nc"));
  };
  CHECK(message(6, 36) == "");
  check_message(message(6, 5), {"dem.nc is cut off", "116 bytes", "take 144", "fetch it again"});
  check_message(message(20000, 36), {"is cut off", "take 1600000000"});
}

TEST_CASE("classic netCDF that tells of more than it holds is refused before room is made for it") {
  const TempFolder folder;
  const std::string whole = netcdf(6, 36);
  const auto message = [&](std::size_t at, const std::string& bytes, std::size_t length) {
    std::string file = whole.substr(0, length);
    file.replace(at, bytes.size(), bytes);
    std::ofstream(folder.file("dem.nc"), std::ios::binary) << file;
    return raster_message(folder.file("dem.nc"));
  };
  // Where the header has the number of dimensions, the length of the first one's name, and the
  // number of the variable's dimensions.
  for (const std::size_t at : {12U, 16U, 64U})
    check_message(message(at, "\x2c", whole.size()),
                  {"dem.nc is cut off or damaged", "its 240 bytes", "fetch it again"});
  for (std::size_t length = 5; length < 96; ++length) {
    INFO(length << " bytes");
    check_message(message(0, "CDF", length), {"is cut off or damaged"});
  }
  // What should be a list of dimensions is none: the library broke off on one that it couldn't use.
  check_message(message(11, "\x63", whole.size()),
                {"dem.nc is damaged", "isn't one of netCDF", "fetch it again"});
  // What doesn't begin as such a file is for others to refuse.
  check_message(message(0, "CDG", whole.size()), {"can't be opened as a raster"});
  check_message(message(3, "\x07", whole.size()), {"can't be opened as a raster"});
}

TEST_CASE("a text of places as a raster, one of which isn't finite, is refused") {
  const TempFolder folder;
  const auto message = [&](const std::string& text) {
    std::ofstream(folder.file("dem.txyz")) << text;
    return raster_message(folder.file("dem.txyz"));
  };
  CHECK(message("x,y,z\n2,2,1\n5,2,63\n2,5,1\n5,5,7\n") == "");
  CHECK(message("x,y,z\n2,2,nan\n5,2,63\n2,5,1\n5,5,7\n") == "");
  // Column by column GDAL finds a raster of 2 x 2 here, and broke off when it was read.
  for (const char* const number : {"nan", "-1.#QNAN", "-NAN"})
    check_message(message("x,y,z\n2,2,1\n5,2,63\n" + std::string(number) + ",188,1888\n"),
                  {"dem.txyz, line 4", number, "finite number"});
}

TEST_CASE("the look at netCDF's header takes nothing from a pipe") {
  const TempFolder folder;
  const std::string path = folder.file("pipe");
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  const int pipe = ::open(path.c_str(), O_RDWR | O_NONBLOCK);
  REQUIRE(pipe >= 0);
  CHECK(::write(pipe, "CDF\x01", 4) == 4);
  check_netcdf_header(path);
  std::array<char, 8> left{};
  CHECK(::read(pipe, left.data(), left.size()) == 4);
  ::close(pipe);
}

TEST_CASE("a raster whose coordinates are too large for its cells is refused, wherever it is") {
  const TempFolder folder;
  const auto message = [&](double west, double cell, const std::string& crs) {
    RasterFile raster = counting_raster(4, 3);
    raster.geotransform = {west, cell, 0, 5000000, 0, -cell};
    raster.crs = crs;
    write_raster(raster, folder.file("far.tif"));
    return raster_message(folder.file("far.tif"));
  };
  for (const std::string crs : {"", "EPSG:32632", "EPSG:3857"}) {
    check_message(message(1e98, 10, crs), {"far.tif", "reach 1e+98", "cells of 10"});
    CHECK(message(1e9, 10, crs) == "");
    // GDAL's way from the coordinates of web maps to degrees never ended here.
    CHECK(message(1e98, 1e97, crs) == "");
  }
}

TEST_CASE("files that aren't rasters are refused") {
  const TempFolder folder;
  check_message(raster_message(folder.file("missing.tif")), {"missing.tif", "no such file"});
  std::ofstream(folder.file("words.txt")) << "not a raster\n";
  check_message(raster_message(folder.file("words.txt")),
                {"words.txt", "can't be opened", "GeoTIFF"});
  check_message(raster_message(folder.path().string()), {"can't be opened"});
  // An archive in which nothing is found.
  std::ofstream(folder.file("dem.zip")) << "not a zip\n";
  check_message(raster_message(folder.file("dem.zip")), {"archive", "/vsizip/"});
}

TEST_CASE("a CRS in a file of its own that can't be read as one is not taken for none") {
  const TempFolder folder;
  std::ofstream(folder.file("dem.asc"))
      << "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n3 4\n";
  CHECK(raster_message(folder.file("dem.asc")) == "");
  std::ofstream(folder.file("dem.prj")) << "not a CRS\n";
  check_message(raster_message(folder.file("dem.asc")), {"dem.prj", "CRS of", "take it away"});
  std::filesystem::remove(folder.file("dem.prj"));
  std::filesystem::create_directory(folder.file("dem.prj"));
  check_message(raster_message(folder.file("dem.asc")), {"dem.prj"});
}

TEST_CASE("truncated files are refused, wherever they end") {
  const TempFolder folder;
  for (const char* compression : {"NONE", "DEFLATE"}) {
    RasterFile raster = counting_raster(200, 150);
    raster.creation_options = {std::string("COMPRESS=") + compression};
    write_raster(raster, folder.file("dem.tif"));
    const auto size = std::filesystem::file_size(folder.file("dem.tif"));
    for (const double part : {0.01, 0.3, 0.6, 0.95, 0.999}) {
      const std::string cut = folder.file("cut.tif");
      std::filesystem::copy_file(folder.file("dem.tif"), cut,
                                 std::filesystem::copy_options::overwrite_existing);
      std::filesystem::resize_file(cut, static_cast<std::uintmax_t>(part * double(size)));
      INFO(compression << " cut at " << part);
      check_message(raster_message(cut), {"cut.tif"});
    }
  }
}

TEST_CASE("windows that hold nothing are refused") {
  const RasterFile raster = counting_raster(20, 10);
  refused(raster, {"holds nothing", "reaches from 500005,4999905 to 500195,4999995"},
          window(0, 0, 100, 100));
  refused(raster, {"holds 1 x 10 vertices", "2 x 2"}, window(500000, 4999900, 500010, 5000000));
  refused(raster, {"is empty", "south-west"}, window(500100, 4999900, 500000, 5000000));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused(raster, {"is empty"}, window(nan, 4999900, 500000, 5000000));
}

TEST_CASE("rasters without a surface are refused") {
  RasterFile raster = counting_raster(20, 10);
  raster.nodata = -1;
  raster.values.assign(raster.values.size(), -1);
  refused(raster, {"holds no heights", "nodata"});
  refused(counting_raster(1, 30), {"1 x 30 cells", "2 x 2"});
  refused(counting_raster(30, 1), {"30 x 1 cells", "2 x 2"});
  RasterFile flat = counting_raster(5, 5);
  flat.geotransform = {500000, 10, 20, 5000000, 5, 10};
  refused(flat, {"geotransform"});
}

TEST_CASE("bands and overviews that aren't there are refused") {
  RasterFile raster = counting_raster(20, 10);
  ReadOptions options;
  options.band = 2;
  refused(raster, {"no band 2", "one band"}, options);
  options.band = 0;
  raster.bands = 3;
  refused(raster, {"no band 0", "1 to 3"}, options);
  options = {};
  options.overview = 0;
  refused(raster, {"no overview 0", "it has none", "gdaladdo"}, options);
  raster.overviews = {2, 4};
  options.overview = 2;
  refused(raster, {"no overview 2", "0 to 1"}, options);
  options.overview = -1;
  refused(raster, {"no overview -1", "0 to 1"}, options);
}

TEST_CASE("degrees that are no place on the earth are refused") {
  RasterFile raster = counting_raster(20, 10);
  raster.crs = "EPSG:4326";
  const auto place = [&](double west, double north, double step = 0.01) {
    raster.geotransform = {west, step, 0, north, 0, -step};
  };
  place(10, 90.05);
  refused(raster, {"latitude 89.955 to 90.045", "-90 to 90", "`bbox`"});
  place(10, -89.95);
  refused(raster, {"to -89.955 degrees", "`bbox`"});
  place(46, 120);
  refused(raster, {"119.9", "longitude comes first"});
  raster.geotransform = {-180, 19.1, 0, 80, 0, -0.1};
  refused(raster, {"round the earth more than once"});
  raster.geotransform = {6, 0.01, 0.001, 46, 0.001, -0.01};
  refused(raster, {"turned against meridians", "gdalwarp"});
  place(6, 46);
  raster.crs = "EPSG:4978";
  refused(raster, {"geocentric"});
}

TEST_CASE("pictures are refused with what to do") {
  RasterFile raster = counting_raster(16, 16);
  raster.type = "Byte";
  raster.bands = 4;
  raster.colours = {"Red", "Green", "Blue", "Alpha"};
  refused(raster, {"colours", "Red", "Terrain-RGB", "gdal_calc.py", "R*65536"});
  ReadOptions alpha;
  alpha.band = 4;
  refused(raster, {"colours", "Alpha"}, alpha);
  raster.bands = 1;
  raster.colours = {"Palette"};
  refused(raster, {"palette"});
}

TEST_CASE("values and places that aren't a grid of heights are refused") {
  RasterFile raster = counting_raster(20, 10);
  raster.type = "CFloat32";
  refused(raster, {"complex"});
  raster.type = "Float32";
  raster.unit = "fathom";
  refused(raster, {"fathom", "us-ft", "gdal_edit.py"});
  raster.unit = "metre";
  raster.geotransform.reset();
  raster.control_points = true;
  refused(raster, {"ground control points", "gdalwarp"});
}

TEST_CASE("an open option without a value is refused") {
  ReadOptions options;
  options.open_options = {"NUM_THREADS"};
  refused(counting_raster(4, 4), {"NUM_THREADS", "NAME=VALUE"}, options);
  options.open_options = {"NUM_THREADS=2"};
  const TempFolder folder;
  write_raster(counting_raster(4, 4), folder.file("dem.tif"));
  CHECK(raster_message(folder.file("dem.tif"), options).empty());
}

// Bytes of a little-endian TIFF, in which the value of a tag lies beyond the end of the file.
std::string with_lost_tag(std::string bytes, unsigned tag) {
  const auto number = [&](std::size_t at, int count) {
    std::size_t value = 0;
    for (int i = count; i-- > 0;)
      value = value << 8 | static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i)));
    return value;
  };
  const std::size_t fields = number(4, 4);
  for (std::size_t i = 0; i < number(fields, 2); ++i)
    if (const std::size_t field = fields + 2 + 12 * i; number(field, 2) == tag) {
      bytes.replace(field + 8, 4, std::string("\xF0\xFF\xFF\x7F", 4));
      return bytes;
    }
  return "";
}

TEST_CASE("tags of place, CRS or nodata that are cut off are refused, not drawn without them") {
  const TempFolder folder;
  RasterFile raster = counting_raster(20, 20);
  raster.nodata = -9999;
  raster.creation_options = {"COMPRESS=NONE"};
  write_raster(raster, folder.file("dem.tif"));
  std::ifstream file(folder.file("dem.tif"), std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  CHECK(read_raster(folder.file("dem.tif")).doubts.empty());
  for (const auto& [tag, name] : {std::pair{33550u, "GeoPixelScale"},
                                  {33922u, "GeoTiePoints"},
                                  {34735u, "GeoKeyDirectory"},
                                  {42113u, "GDALNoDataValue"}}) {
    const std::string bytes = with_lost_tag(whole, tag);
    REQUIRE(bytes.size() == whole.size());
    std::ofstream(folder.file("lost.tif"), std::ios::binary) << bytes;
    check_message(raster_message(folder.file("lost.tif")), {"lost.tif", "damaged", name});
  }
}

TEST_CASE("a file without a place leaves a doubt, which is a note as well") {
  const TempFolder folder;
  RasterFile raster = counting_raster(4, 4);
  raster.geotransform.reset();
  write_raster(raster, folder.file("dem.tif"));
  const TerrainData terrain = read_raster(folder.file("dem.tif"));
  REQUIRE(terrain.doubts.size() == 1);
  CHECK(terrain.doubts.front().find("no georeference") != std::string::npos);
  CHECK(terrain.notes.front() == terrain.doubts.front());
}

} // namespace orograph::read_raster_error_test
