// SPDX-License-Identifier: GPL-3.0-or-later
// Where a block that is closed below ends, below its border
// (docs/decisions/0060-both-sides-of-everything.md).
#pragma once

#include "dem/terrain.hpp"
#include "placing/placed_view.hpp"
#include "profiles/slab_lines.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

class BlockFeet {
public:
  /// In the profile frame of one of its sectors. REQUIRES a terrain that was placed as a block.
  BlockFeet(const TerrainData& terrain, const PlacedView& placed, const View& view);

  /// The foot of the wall below an edge of the border.
  ProfileLine below(SurfaceEdge edge) const;
  /// Where the near plane cuts the base, in the visibility plane. REQUIRES a perspective view.
  double y_at_near_plane() const { return y_at_near_plane_; }

private:
  ProfilePoint foot(std::uint32_t vertex) const;

  std::vector<std::uint32_t> vertices_; ///< of the border, rising
  std::vector<ProfilePoint> feet_;
  double y_at_near_plane_ = 0;
};

} // namespace orograph
