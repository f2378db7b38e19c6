// SPDX-License-Identifier: GPL-3.0-or-later
// What an eye sees of a raster of which larger cells were read: what it needs in the raster's own.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/part_of_grid.hpp"
#include "dem/levels/patches.hpp"
#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"
#include "placing/patches_of_view.hpp"
#include "placing/placed_view.hpp"

#include <vector>

namespace orograph {

/// How much higher than the larger cells the raster's own are at a place of the ground frame, in
/// metres; 0 where these aren't known.
double rise_of_raster(const TerrainData& terrain, const Grid& raster, Vec2 ground_m);

/// Those of the parts that weren't read.
std::vector<GridPart> without_known(std::vector<GridPart> parts, const LargerCells& read);

/// Patches of a raster about an eye, none of smaller cells than its own. While parts are missing
/// they are those that the larger cells ask for; once none is, what the raster's own cells hide of
/// each other is as coarse as may be, too.
class PatchesOfRaster {
public:
  /// REQUIRES a terrain with `larger_cells`, as the view needs it, an eye over its ground, and the
  /// picture of it placed, and the ranges of its larger cells; terrain and ranges outlive this.
  PatchesOfRaster(const TerrainData& terrain, const GroundRanges& ranges, PlacedView placed,
                  const MapSpec& spec);
  PatchesOfRaster(const PatchesOfRaster&) = delete;
  PatchesOfRaster& operator=(const PatchesOfRaster&) = delete;

  const Grid& raster() const { return raster_; } ///< its lattice, without heights
  const Patches& patches() const { return patches_; }
  double mm_per_m(const PatchPlace& part) const { return scale_.mm_per_m(part); }

  /// Parts of the raster that are needed and the terrain doesn't have.
  const std::vector<GridPart>& missing() const { return missing_; }

private:
  Grid raster_;
  PlacedView placed_;
  ScaleOnPage scale_;
  Patches patches_;
  std::vector<GridPart> missing_;
};

} // namespace orograph
