// SPDX-License-Identifier: GPL-3.0-or-later
// Files for tests of the command line.
#include "tests/cli/made_files.hpp"

#include <stdlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace orograph {

namespace fs = std::filesystem;

MadeFolder::MadeFolder() : path_((fs::temp_directory_path() / "orograph-test-XXXXXX").string()) {
  if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no temporary folder");
}

MadeFolder::~MadeFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string MadeFolder::write(const std::string& name, std::string_view content) const {
  std::ofstream file(path(name), std::ios::binary);
  file << content;
  file.close();
  if (!file) throw std::runtime_error("can't write " + name);
  return path(name);
}

std::string MadeFolder::read(const std::string& name) const {
  std::ifstream file(path(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> MadeFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(path_))
    names.push_back(fs::relative(entry.path(), path_).string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string ascii_grid(int columns, int rows, const HeightOf& height_m, const AsciiPlace& place) {
  std::ostringstream text;
  text << "ncols " << columns << "\nnrows " << rows << "\nxllcorner " << place.x << "\nyllcorner "
       << place.y << "\ncellsize " << place.cell << "\nNODATA_value -9999\n";
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      text << height_m(column, row) << (column + 1 < columns ? ' ' : '\n');
  return text.str();
}

namespace {

/// Little-endian bytes.
template <typename Value>
void put(std::string& bytes, Value value) {
  for (std::size_t i = 0; i < sizeof(Value); ++i)
    bytes += static_cast<char>(value >> (8 * i) & 0xff);
}
void put_double(std::string& bytes, double value) {
  put(bytes, std::bit_cast<std::uint64_t>(value));
}
void put_float(std::string& bytes, float value) {
  put(bytes, std::bit_cast<std::uint32_t>(value));
}

enum FieldType : std::uint16_t { kShort = 3, kLong = 4, kDouble = 12 };

void put_field(std::string& bytes, std::uint16_t tag, FieldType type, std::uint32_t count,
               std::uint32_t value_or_place) {
  put(bytes, tag);
  put(bytes, static_cast<std::uint16_t>(type));
  put(bytes, count);
  put(bytes, value_or_place);
}

} // namespace

std::string geotiff(int columns, int rows, const HeightOf& height_m) {
  constexpr std::uint16_t kFields = 13;
  constexpr std::uint32_t kScale = 8 + 2 + 12 * kFields + 4, kTiepoint = kScale + 3 * 8,
                          kHeights = kTiepoint + 6 * 8;
  const auto width = static_cast<std::uint32_t>(columns), height = static_cast<std::uint32_t>(rows);
  std::string bytes = "II";
  put(bytes, std::uint16_t{42});
  put(bytes, std::uint32_t{8}); // the only directory of fields follows
  put(bytes, kFields);
  put_field(bytes, 256, kLong, 1, width);
  put_field(bytes, 257, kLong, 1, height);
  put_field(bytes, 258, kShort, 1, 32); // bits per sample
  put_field(bytes, 259, kShort, 1, 1);  // no compression
  put_field(bytes, 262, kShort, 1, 1);  // black is zero
  put_field(bytes, 273, kLong, 1, kHeights);
  put_field(bytes, 277, kShort, 1, 1);     // samples per pixel
  put_field(bytes, 278, kLong, 1, height); // rows per strip
  put_field(bytes, 279, kLong, 1, 4 * width * height);
  put_field(bytes, 284, kShort, 1, 1); // planes
  put_field(bytes, 339, kShort, 1, 3); // floating point
  put_field(bytes, 33550, kDouble, 3, kScale);
  put_field(bytes, 33922, kDouble, 6, kTiepoint);
  put(bytes, std::uint32_t{0});
  for (const double size_m : {10.0, 10.0, 0.0}) put_double(bytes, size_m);
  for (const double value : {0.0, 0.0, 0.0, 0.0, 10.0 * rows, 0.0}) put_double(bytes, value);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      put_float(bytes, static_cast<float>(height_m(column, row)));
  return bytes;
}

const std::string_view kUtm32 =
    "PROJCS[\"WGS 84 / UTM zone 32N\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\","
    "6378137,298.257223563]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],"
    "PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],"
    "PARAMETER[\"central_meridian\",9],PARAMETER[\"scale_factor\",0.9996],"
    "PARAMETER[\"false_easting\",500000],PARAMETER[\"false_northing\",0],UNIT[\"metre\",1]]";

double hill_m(int column, int row, int size) {
  const double x = 2.0 * column / (size - 1) - 1, y = 2.0 * row / (size - 1) - 1;
  return 100 + 200 * std::exp(-4 * (x * x + y * y)) + 7 * x + 3 * y;
}

} // namespace orograph
