// SPDX-License-Identifier: GPL-3.0-or-later
// make_terrains OUT_DIR [VERTICES]: writes every made terrain as an Arc/Info ASCII grid, heights
// rounded to decimetres, and the islands' heights once more over a degree. They lie in the Gulf of
// Guinea, where nobody takes them for real ones. make_terrains.sh makes GeoTIFFs of them.
#include "data_samples/terrains.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

namespace {

using orograph::Grid;
using orograph::Vec2;

constexpr Vec2 corner{500000, 100000}; // south-west vertex, UTM zone 31N
constexpr Vec2 corner_deg{2, 0};       // longitude and latitude
constexpr int committed_vertices = 301;

// `south_west` and `step` in the units of the file's CRS.
bool write(const Grid& grid, Vec2 south_west, double step, const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "w");
  if (!file) return false;
  // Cells are named by their corners: half a step before the south-west vertex.
  std::fprintf(file, "ncols %d\nnrows %d\nxllcorner %.17g\nyllcorner %.17g\ncellsize %.17g\n",
               grid.columns, grid.rows, south_west.x - step / 2, south_west.y - step / 2, step);
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
  const auto write_all = [&] {
    const std::string folder = std::string(arguments[1]) + "/";
    for (const auto terrain : orograph::all_made_terrains) {
      const Grid grid = make_terrain(terrain, vertices);
      const std::string path = folder + name_of(terrain) + ".asc";
      if (!write(grid, corner, grid.plane().column_step_m.x, path)) return path;
    }
    const Grid islands = make_terrain(orograph::MadeTerrain::islands, vertices);
    const std::string path = folder + "archipelago.asc";
    return write(islands, corner_deg, 1. / (vertices - 1), path) ? std::string() : path;
  };
  const std::string failed = write_all();
  if (failed.empty()) return 0;
  std::fprintf(stderr, "make_terrains: error: %s can't be written\n", failed.c_str());
  return 1;
}
