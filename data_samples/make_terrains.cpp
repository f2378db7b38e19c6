// SPDX-License-Identifier: GPL-3.0-or-later
// make_terrains OUT_DIR [VERTICES]: writes every made terrain as an Arc/Info ASCII grid, heights
// rounded to decimetres. They lie in the Gulf of Guinea, where nobody takes them for real ones.
// make_terrains.sh makes GeoTIFFs of them.
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

#include "data_samples/terrains.hpp"

namespace {

using orograph::Grid;
using orograph::Vec2;

constexpr Vec2 corner{500000, 100000}; // south-west vertex, UTM zone 31N
constexpr int committed_vertices = 301;

bool write(const Grid& grid, const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "w");
  if (!file) return false;
  // Cells are named by their corners: half a step before the south-west vertex.
  const double step = grid.plane().column_step_m.x;
  std::fprintf(file, "ncols %d\nnrows %d\nxllcorner %.17g\nyllcorner %.17g\ncellsize %.17g\n",
               grid.columns, grid.rows, corner.x - step / 2, corner.y - step / 2, step);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      std::fprintf(file, "%.1f%c", std::floor(10 * grid.height_m(column, row) + 0.5) / 10,
                   column + 1 < grid.columns ? ' ' : '\n');
  const bool written = std::ferror(file) == 0;
  return std::fclose(file) == 0 && written;
}

} // namespace

int main(int count, char** arguments) {
  int vertices = committed_vertices;
  if (count == 3) std::from_chars(arguments[2], arguments[2] + std::strlen(arguments[2]), vertices);
  if (count < 2 || count > 3 || vertices < 2) {
    std::fprintf(stderr, "usage: make_terrains OUT_DIR [VERTICES]\n");
    return 2;
  }
  for (const auto terrain : orograph::all_made_terrains) {
    const std::string path = std::string(arguments[1]) + "/" + name_of(terrain) + ".asc";
    if (!write(make_terrain(terrain, vertices), path)) {
      std::fprintf(stderr, "make_terrains: error: %s can't be written\n", path.c_str());
      return 1;
    }
  }
  return 0;
}
