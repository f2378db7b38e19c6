// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/block_feet.hpp"

#include "placing/block.hpp"

#include <algorithm>

namespace orograph {

BlockFeet::BlockFeet(const TerrainData& terrain, const PlacedView& placed, const View& view)
    : vertices_(vertices_of(placed.border)) {
  for (const Vec3& foot : block_feet_m(terrain, placed.border, *placed.block_base_m))
    feet_.push_back(to_profile_frame(view, foot));
  if (view.is_perspective())
    y_at_near_plane_ =
        (base_z_m(*placed.block_base_m, view, terrain.map) - view.eye_z_m) / view.near_m;
}

ProfilePoint BlockFeet::foot(std::uint32_t vertex) const {
  const auto at = std::ranges::lower_bound(vertices_, vertex) - vertices_.begin();
  return feet_[static_cast<std::size_t>(at)];
}

ProfileLine BlockFeet::below(SurfaceEdge edge) const {
  return {foot(edge.from), foot(edge.to)};
}

} // namespace orograph
