// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/tile_errors.hpp"

#include "dem/read/in_brief.hpp"
#include "dem/read/window_words.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace orograph {
namespace {

std::string cells_in_words(const RasterLattice& lattice) {
  return fmt::format("{:.10g} x {:.10g}", length(lattice.pixel_step), length(lattice.line_step));
}

// A file's name with "_joined" before its extension, beside nothing: where the user works.
std::string name_of_copy(const std::string& path) {
  return std::filesystem::path(path).stem().string() + "_joined.tif";
}

// The command that resamples the tile to the base's lattice: to those of its cells whose centres
// are in the tile's cells, so that none at the tile's border are left without a height.
std::string warp_to(const Tile& base, const Tile& tile) {
  const RasterLattice &b = base.lattice, &t = tile.lattice;
  const bool upright = b.pixel_step.y == 0 && b.line_step.x == 0;
  if (!upright)
    return fmt::format("make one raster of them: gdalwarp -r cubic {} {} joined.tif", base.path,
                       tile.path);
  Box2 cells; // of the tile, counted in the base's vertices
  for (const double pixel : {-0.5, t.pixels - 0.5})
    for (const double line : {-0.5, t.lines - 0.5})
      cells.include(b.index_of(t.position(pixel, line)));
  const double slack = 1e-6;
  const Vec2 north_west =
      b.position(std::ceil(cells.low.x - slack) - 0.5, std::ceil(cells.low.y - slack) - 0.5);
  const Vec2 south_east =
      b.position(std::floor(cells.high.x + slack) + 0.5, std::floor(cells.high.y + slack) + 0.5);
  return fmt::format("resample one to the other's: gdalwarp -r cubic -tr {:.15g} {:.15g} -te "
                     "{:.15g} {:.15g} {:.15g} {:.15g} {} {}",
                     b.pixel_step.x, -b.line_step.y, north_west.x, south_east.y, south_east.x,
                     north_west.y, tile.path, name_of_copy(tile.path));
}

} // namespace

void refuse_lattices(const Tile& base, const Tile& tile, bool same_steps,
                     std::optional<int> overview) {
  if (overview)
    throw Error(
        fmt::format("overviews {} of {} and {} aren't on one lattice of vertices", *overview,
                    base.path, tile.path),
        "leave --overview out, or make one file with overviews of its own: gdalbuildvrt all.vrt "
        "FILES && gdaladdo -ro all.vrt 2 4 8");
  if (!same_steps)
    throw Error(fmt::format("{} has cells of {}, and {} of {}", tile.path,
                            cells_in_words(tile.lattice), base.path, cells_in_words(base.lattice)),
                warp_to(base, tile));
  const Vec2 index = base.lattice.index_of(tile.lattice.first);
  throw Error(fmt::format("{} is {:.5g} x {:.5g} of a cell beside the lattice of {}", tile.path,
                          std::abs(index.x - std::round(index.x)),
                          std::abs(index.y - std::round(index.y)), base.path),
              warp_to(base, tile));
}

void refuse_apart(const std::vector<Tile>& tiles, const std::vector<bool>& together) {
  std::vector<std::string> apart;
  Box2 there, others;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const Box2 box = box_of(tiles[i].lattice);
    Box2& into = together[i] ? others : there;
    if (!together[i]) apart.push_back(tiles[i].path);
    into.include(box.low);
    into.include(box.high);
  }
  throw Error(fmt::format("{} ({}) {} the other files ({})", in_brief(apart), in_words(there),
                          apart.size() == 1 ? "doesn't touch" : "don't touch", in_words(others)),
              "files of one terrain overlap or lie side by side: add what lies between, or draw "
              "them one by one");
}

} // namespace orograph
