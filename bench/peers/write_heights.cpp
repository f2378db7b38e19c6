// SPDX-License-Identifier: GPL-3.0-or-later
// A DEM in the form that the peers which don't read GeoTIFF take quickest.
//
//   write_heights DEM OUTPUT.heights    raw float32 (heights.h)
//   write_heights DEM OUTPUT.z          text, as GLE reads it
#include "dem/read/read_raster.hpp"
#include "geometry/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "programs/heights.h"

using namespace orograph;

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::vector<float> from_the_south(const Grid& grid) {
  std::vector<float> heights;
  heights.reserve(grid.size());
  for (int row = grid.rows; row-- > 0;)
    for (int column = 0; column < grid.columns; ++column)
      heights.push_back(static_cast<float>(grid.height_m(column, row)));
  return heights;
}

void write(const Grid& grid, const std::string& dem, const std::string& path) {
  if (grid.is_on_earth())
    throw Error(dem + " is in degrees, which most peers don't know",
                "bring it to a map in metres with gdalwarp -t_srs");
  const PlaneLattice& plane = grid.plane();
  if (plane.column_step_m.y != 0 || plane.row_step_m.x != 0)
    throw Error(dem + " is rotated", "bring it to the map's axes with gdalwarp");
  const std::vector<float> heights = from_the_south(grid);
  if (std::any_of(heights.begin(), heights.end(), [](float h) { return !std::isfinite(h); }))
    throw Error(dem + " has places without a height, which most peers can't leave out",
                "cut out a full window with gdal_translate -srcwin");
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  const File file(std::fopen(path.c_str(), "wb"), std::fclose);
  const Error failed(path + " can't be written", "name a folder with free space");
  if (!file) throw failed;
  if (path.ends_with(".z")) {
    // Its x runs away from the viewer of `rotate 0 60 0` here: a line a column, from the north.
    std::fprintf(file.get(), "! nx %d ny %d xmin 0 xmax %.9g ymin 0 ymax %.9g\n", grid.rows,
                 grid.columns, -(grid.rows - 1) * plane.row_step_m.y,
                 (grid.columns - 1) * plane.column_step_m.x);
    for (int column = 0; column < grid.columns; ++column)
      for (int row = 0; row < grid.rows; ++row)
        std::fprintf(file.get(), "%.9g%c", grid.height_m(column, row),
                     row + 1 < grid.rows ? ' ' : '\n');
  } else {
    char header[HEIGHTS_HEADER + 1];
    std::snprintf(header, sizeof header, "%d %d %.9g %.9g %.9g %.9g", grid.columns, grid.rows,
                  plane.column_step_m.x, -plane.row_step_m.y, static_cast<double>(*lowest),
                  static_cast<double>(*highest));
    std::fprintf(file.get(), "%-*s\n", HEIGHTS_HEADER - 1, header);
    std::fwrite(heights.data(), sizeof(float), heights.size(), file.get());
  }
  if (std::fflush(file.get()) != 0 || std::ferror(file.get()) != 0) throw failed;
}

} // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fputs("usage: write_heights DEM OUTPUT.heights|OUTPUT.z\n", stderr);
    return 2;
  }
  try {
    write(std::get<Grid>(read_raster(arguments[1]).surface), arguments[1], arguments[2]);
  } catch (const Error& error) {
    std::fprintf(stderr, "write_heights: error: %s\n", error.what());
    return 1;
  }
}
