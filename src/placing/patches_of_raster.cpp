// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/patches_of_raster.hpp"

#include "dem/height_at.hpp"
#include "dem/levels/raster_patches.hpp"
#include "placing/cell_on_page.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

namespace orograph {
namespace {

const Grid& larger_cells(const TerrainData& terrain) {
  return std::get<Grid>(terrain.surface);
}

// Ground that an eye sees lies aslant: cells of three times the size, 1.2 mm, draw the same (looked
// at: eyes over the White Mountains and in the Nordkette, on A4 and A3).
CellSizes size_for_eye(const Style& style) {
  CellSizes sizes = asked_size(style);
  if (!style.detail.cell_mm) sizes.least_mm *= 3;
  return sizes;
}

// Of the raster's own cells, where these are known there.
std::optional<double> height_of_raster(const Grid& raster, const LargerCells& read, Vec2 ground_m) {
  for (const RasterPart& part : read.parts) {
    const auto corner = [&](int column, int row) {
      const Vec3 at = std::visit(
          [&](const auto& lattice) {
            return lattice.vertex_m(part.at.first_column + column, part.at.first_row + row, 0);
          },
          raster.lattice);
      return Vec2{at.x, at.y};
    };
    Box2 box;
    for (const int column : {0, part.at.columns - 1})
      for (const int row : {0, part.at.rows - 1}) box.include(corner(column, row));
    if (ground_m.x < box.low.x || ground_m.x > box.high.x || ground_m.y < box.low.y ||
        ground_m.y > box.high.y)
      continue;
    const Grid cells{part.at.columns, part.at.rows, lattice_of_part(raster, part.at),
                     part.cells.heights_m};
    if (const auto height = height_at(cells, ground_m)) return height;
  }
  return std::nullopt;
}

// Of the raster, where its own cells may hide each other: where they are asked for, and as far from
// the eye as they aren't too many. 4,900 x 3,300 of them take 14 ms.
std::optional<GridPart> window_about_eye(const Patches& patches, const LargerCells& read,
                                         const ScaleOnPage& scale) {
  constexpr double kMostCells = 1 << 24;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  PatchPlace eye{kFar, -kFar, kFar, -kFar}, asked = eye;
  const auto include = [](PatchPlace& all, const PatchPlace& part) {
    all = {std::min(all.first_column, part.first_column),
           std::max(all.last_column, part.last_column), std::min(all.first_row, part.first_row),
           std::max(all.last_row, part.last_row)};
  };
  for (const Patch& patch : patches.patches()) {
    if (std::ldexp(1, patch.level) >= read.step) continue;
    const PatchPlace part = patches.place_of(patch);
    include(asked, part);
    if (std::isinf(scale.mm_per_m(part))) include(eye, part);
  }
  if (!(eye.first_column <= eye.last_column)) return std::nullopt;
  for (double reach = kMostCells;; reach /= 2) {
    const PatchPlace part{std::max(asked.first_column, eye.first_column - reach),
                          std::min(asked.last_column, eye.last_column + reach),
                          std::max(asked.first_row, eye.first_row - reach),
                          std::min(asked.last_row, eye.last_row + reach)};
    const double columns = part.last_column - part.first_column + 1,
                 rows = part.last_row - part.first_row + 1;
    if (columns * rows <= kMostCells)
      return GridPart{static_cast<int>(part.first_column), static_cast<int>(part.first_row),
                      static_cast<int>(columns), static_cast<int>(rows)};
  }
}

// An eye over the ground stands on the raster's own cells, which may be higher than larger ones:
// there it sees more.
PlacedView on_own_cells(PlacedView placed, const TerrainData& terrain, const Grid& raster) {
  View& view = placed.view;
  view.eye_z_m +=
      std::max(0.0, rise_of_raster(terrain, raster, view.depth_origin_m)) * view.exaggeration;
  return placed;
}

} // namespace

double rise_of_raster(const TerrainData& terrain, const Grid& raster, Vec2 ground_m) {
  const auto own = height_of_raster(raster, *terrain.larger_cells, ground_m),
             larger = height_at(larger_cells(terrain), ground_m);
  return own && larger ? *own - *larger : 0;
}

std::vector<GridPart> without_known(std::vector<GridPart> parts, const LargerCells& read) {
  std::erase_if(parts, [&](const GridPart& part) {
    return std::ranges::any_of(read.parts, [&](const RasterPart& known) {
      return known.at.first_column == part.first_column && known.at.first_row == part.first_row;
    });
  });
  return parts;
}

PatchesOfRaster::PatchesOfRaster(const TerrainData& terrain, const GroundRanges& ranges,
                                 PlacedView placed, const MapSpec& spec)
    : raster_(lattice_of_raster(larger_cells(terrain), *terrain.larger_cells)),
      placed_(on_own_cells(std::move(placed), terrain, raster_)),
      scale_(larger_cells(terrain), ranges, placed_, &raster_),
      patches_(patches_of_view(raster_, scale_, size_for_eye(spec.style), 0)),
      missing_(without_known(parts_under(*terrain.larger_cells, patches_), *terrain.larger_cells)) {
  if (!missing_.empty()) return;
  const auto window = window_about_eye(patches_, *terrain.larger_cells, scale_);
  if (!window) return;
  scale_.look_at_cells(*window, own_cells_in(*window, raster_, *terrain.larger_cells));
  patches_ = patches_of_view(raster_, scale_, size_for_eye(spec.style), 0);
}

} // namespace orograph
