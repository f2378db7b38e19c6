// SPDX-License-Identifier: GPL-3.0-or-later
// What of a block an eye sees, by its definition: a solid with the surface on top, walls down to a
// base, and nothing below. Shares no code with the pass, nor with the other ray walk.
#pragma once

#include "dem/terrain.hpp"
#include "geometry/profile_point.hpp"
#include "placing/placed_view.hpp"
#include "view/view.hpp"

#include <array>
#include <vector>

namespace orograph {

/// A wall: the upper edge, and the two places below its ends.
struct BlockWall {
  ProfilePoint a, b, a_foot, b_foot;
};

class BlockWalk {
public:
  /// In the profile frame of `view`. Cost of a point: all triangles and walls.
  BlockWalk(std::vector<std::array<ProfilePoint, 3>> triangles, std::vector<BlockWall> walls,
            const View& view)
      : triangles_(std::move(triangles)), walls_(std::move(walls)), view_(view) {}

  /// By how much the way from the eye to the point is inside of the block at most, as a height in
  /// metres; negative where it passes outside, infinite where it goes through a wall that isn't at
  /// the point itself.
  double depth_inside_m(ProfilePoint point) const;

private:
  std::vector<std::array<ProfilePoint, 3>> triangles_;
  std::vector<BlockWall> walls_;
  const View& view_;
};

/// The walls below all edges of the border of a terrain that was placed as a block, and the
/// triangles of its surface, in the profile frame of a view.
std::vector<BlockWall> walls_in(const TerrainData& terrain, const PlacedView& placed,
                                const View& view);
std::vector<std::array<ProfilePoint, 3>> triangles_in(const TerrainData& terrain, const View& view);

} // namespace orograph
