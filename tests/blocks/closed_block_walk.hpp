// SPDX-License-Identifier: GPL-3.0-or-later
// What of a block that is closed below an eye sees, by its definition: a solid between the surface
// and its base. Shares no code with the pass.
#pragma once

#include "dem/terrain.hpp"
#include "geometry/profile_point.hpp"
#include "placing/placed_view.hpp"
#include "view/view.hpp"

#include <array>
#include <vector>

namespace orograph {

class ClosedBlockWalk {
public:
  /// In the profile frame of `view`. REQUIRES a terrain that was placed as a block. Cost of a
  /// point: all triangles.
  ClosedBlockWalk(const TerrainData& terrain, const PlacedView& placed, const View& view);

  /// By how much the way from the point to the eye is inside of the block at most, as a height
  /// above its base or below its surface; negative where it passes outside. `tilt`: by how much the
  /// way rises more, over its length seen from above.
  double depth_inside_m(ProfilePoint point, double tilt = 0) const;

private:
  struct Corner {
    ProfilePoint top;
    double base_z;
  };
  std::vector<std::array<Corner, 3>> prisms_;
  const View& view_;
};

} // namespace orograph
