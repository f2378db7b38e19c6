// SPDX-License-Identifier: GPL-3.0-or-later
// The ray walk over a TIN.
#pragma once

#include "dem/mesh/tin_index.hpp"
#include "dem/tin.hpp"
#include "geometry/box.hpp"
#include "geometry/profile_point.hpp"
#include "reference/in_front.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

/// A `RayWalk` (reference/ray_walk.hpp) that asks every triangle near the ray's ground line. It
/// doesn't follow neighbours, as the cut does: it needs none where the terrain has a hole, and can
/// tell where they are wrong. A point costs O(triangles near the line).
class TinRayWalk {
public:
  TinRayWalk(const Tin& tin, const View& view);
  InFront in_front(ProfilePoint p) const;

private:
  const Tin& tin_;
  View view_;
  TinIndex index_;
  double reach_m_ = 0;                      ///< bound on the coordinates in the ground frame
  double highest_m_ = 0;                    ///< greatest height, or depth below zero, exaggerated
  mutable std::vector<std::uint32_t> near_; ///< triangles, reused from point to point
};

} // namespace orograph
