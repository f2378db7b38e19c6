// SPDX-License-Identifier: GPL-3.0-or-later
// What ground a page shows: the way back from a point of the page to the terrain.
#pragma once

#include "dem/grid.hpp"
#include "placing/placed_view.hpp"
#include "profiles/level_ground.hpp"

#include <optional>
#include <vector>

namespace orograph {

struct ShownGround {
  const Sector* sector = nullptr;
  ProfilePoint at;       ///< in the sector's profile frame
  Vec3 normal;           ///< unit, upwards, in the ground frame; of the exaggerated ground
  bool is_level = false; ///< water (`find_water`), on which no profiles are drawn
};

/// Follows the ray of a point of the page from triangle to triangle until it comes below the
/// ground. Above the terrain's near border, or a gap's far one, there is ground; below there is
/// none.
class PageGround {
public:
  /// REQUIRES a grid on a map plane, and that both outlive this.
  PageGround(const Grid& grid, const PlacedView& placed);

  /// None where the page shows none. Cost: O(columns + rows).
  std::optional<ShownGround> at(Vec2 page_mm) const;
  /// Whether on the straight way between two points there is a place without ground, or one where
  /// it jumps from a surface to another behind it: by more than what makes a silhouette of a fold.
  bool jumps_between(Vec2 from_mm, Vec2 to_mm) const;

private:
  std::optional<ShownGround> on_ray(const Sector& sector, Vec2 ray) const;
  bool jumps_between(Vec2 from_mm, const ShownGround& from, Vec2 to_mm,
                     const ShownGround& to) const;

  const Grid& grid_;
  const PlacedView& placed_;
  LevelGround water_;
  std::vector<Homography> to_rays_; ///< from the page to each sector's visibility plane
  Vec2 columns_per_m_, rows_per_m_; ///< a step on the ground in columns, and in rows
};

} // namespace orograph
