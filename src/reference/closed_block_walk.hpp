// SPDX-License-Identifier: GPL-3.0-or-later
// What of a block that is closed below an eye sees, by its definition: a solid between the surface
// and its base. Shares no code with the pass.
#pragma once

#include "dem/terrain.hpp"
#include "geometry/profile_point.hpp"
#include "reference/ways_over_tin.hpp"
#include "view/view.hpp"

#include <vector>

namespace orograph {

class ClosedBlockWalk {
public:
  /// In the profile frame of `view`. `base_m`: height of the base, as heights are in the terrain.
  /// REQUIRES that terrain and view outlive it. Cost: of a grid the TIN of its triangles.
  ClosedBlockWalk(const TerrainData& terrain, double base_m, const View& view);
  /// From now on of another view. What is nearer than its near plane stands in front of nothing.
  void set_view(const View& view) { view_ = &view; }
  /// The side of a square as large as two triangles of mean size, seen from above.
  double cell_m() const { return cell_m_; }

  /// By how much the way from the point to the eye is inside of the block at most, as a height
  /// above its base or below its surface; negative where it passes outside. `tilt`: by how much the
  /// way rises more, over its length seen from above. Cost: the triangles near the way.
  double depth_inside_m(ProfilePoint point, double tilt = 0) const;

private:
  WaysOverTin ways_;
  const View* view_;
  std::vector<double> base_z_m_; ///< by vertex: of the place below it, in the ground frame
  double cell_m_ = 0;
};

} // namespace orograph
