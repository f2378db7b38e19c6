// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/certified_raster.hpp"

#include "dem/levels/nested_cells.hpp"
#include "dem/levels/raster_patches.hpp"
#include "placing/patches_of_raster.hpp"

#include <utility>
#include <variant>

namespace orograph {
namespace {

const NestedCells& nested_cells(const TerrainData& terrain) {
  return *terrain.larger_cells->nested;
}

// Whether an eye's height is told above the ground under it.
bool stands_on_ground(const ViewSpec& view) {
  const bool has_height = view.eye_map ? view.eye_map->z.has_value()
                                       : view.eye_lonlat && view.eye_lonlat->z.has_value();
  return view.has_eye() && !has_height;
}

PlacedView on_own_ground(PlacedView placed, const TerrainData& terrain, const Grid& raster,
                         const ViewSpec& view) {
  if (stands_on_ground(view))
    placed.view.eye_z_m +=
        rise_of_raster(terrain, raster, placed.view.depth_origin_m) * placed.view.exaggeration;
  return placed;
}

} // namespace

bool spare_enough(const Patches& patches, std::size_t heights) {
  constexpr std::size_t kTimesFewer = 10;
  return patches.patches().size() * kPatchCells * kPatchCells <= heights / kTimesFewer;
}

CertifiedRaster::CertifiedRaster(const TerrainData& terrain, PlacedView placed, const MapSpec& spec)
    : terrain_(terrain),
      raster_(lattice_of_raster(std::get<Grid>(terrain.surface), *terrain.larger_cells)),
      placed_(on_own_ground(std::move(placed), terrain, raster_, spec.view)),
      heights_(raster_, placed_, HeightRanges(raster_.columns, nested_cells(terrain).ranges)),
      patches_(certified_patches(raster_, nested_cells(terrain), heights_,
                                 kFramedAnew * *spec.style.detail.error_mm)) {}

// Patches are sewn, and drawn as a TIN: 213 to 250 bytes a cell, of 8000 x 8000 to 20,000 x 20,000
// heights within 0.2 to 0.5 mm on A3 and A2.
std::uint64_t CertifiedRaster::bytes_to_draw() const {
  constexpr std::uint64_t kOfCell = 240;
  return patches_.patches().size() * kPatchCells * kPatchCells * kOfCell +
         nested_size(raster_.size()) * sizeof(float);
}

std::vector<GridPart> CertifiedRaster::missing() const {
  return without_known(parts_under_finest(*terrain_.larger_cells, patches_),
                       *terrain_.larger_cells);
}

} // namespace orograph
