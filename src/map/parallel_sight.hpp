// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in front of a vertex in a parallel view, which has no eye to look around from.
#pragma once

#include "dem/terrain.hpp"
#include "placing/placed_view.hpp"
#include "profiles/cut_surface.hpp"
#include "profiles/profile.hpp"
#include "view/view.hpp"

namespace orograph {

class ParallelSight {
public:
  /// Both outlive it. REQUIRES a parallel view.
  ParallelSight(const TerrainData& terrain, const PlacedView& placed);

  /// By how much a point of the surface would have to be higher in the visibility plane to be seen;
  /// 0 where it is. The whole section of the surface by the upright plane of the point's ray counts
  /// that is nearer than the point by more than a hundredth of a cell. Cost: a profile.
  double hidden_y(ProfilePoint at) const;

private:
  const View& view_;
  View along_; ///< its profiles are those sections
  double near_m_;
  SurfaceCutter cutter_;
};

} // namespace orograph
