// SPDX-License-Identifier: GPL-3.0-or-later
// Certified patches of a raster that isn't in memory as a whole.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/part_of_grid.hpp"
#include "dem/levels/patches.hpp"
#include "dem/terrain.hpp"
#include "placing/certified_patches.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace orograph {

/// The picture of a level is framed anew, and may be larger by so much: less is asked of patches.
constexpr double kFramedAnew = 0.97;

/// Whether a grid of so many heights is drawn quicker in these patches than as it is: of 4000 x
/// 4000 cells a quarter took 1.9 s, in patches, and all of them 0.9 s.
bool spare_enough(const Patches& patches, std::size_t heights);

class CertifiedRaster {
public:
  /// REQUIRES a terrain with `larger_cells` that have nested ones, as the view needs it, the
  /// picture of it placed, and `spec.style.detail.error_mm`; the terrain outlives this.
  CertifiedRaster(const TerrainData& terrain, PlacedView placed, const MapSpec& spec);
  CertifiedRaster(const CertifiedRaster&) = delete;
  CertifiedRaster& operator=(const CertifiedRaster&) = delete;

  const Grid& raster() const { return raster_; } ///< its lattice, without heights
  const Patches& patches() const { return patches_; }
  const HeightOnPage& heights() const { return heights_; }
  bool spares_enough() const { return spare_enough(patches_, raster_.size()); }
  std::uint64_t bytes_to_draw() const; ///< memory that a drawing in these patches takes, about

  /// Parts of the raster that the patches need and the terrain doesn't have. An eye on the ground
  /// stands on these: once they are there patches are to be chosen anew.
  std::vector<GridPart> missing() const;

private:
  const TerrainData& terrain_;
  Grid raster_;
  PlacedView placed_;
  HeightOnPage heights_;
  Patches patches_;
};

} // namespace orograph
