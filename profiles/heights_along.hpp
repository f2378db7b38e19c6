// SPDX-License-Identifier: GPL-3.0-or-later
// The ground's heights at places along a profile that isn't cut.
#pragma once

#include "dem/grid.hpp"
#include "profiles/profile.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Places at even distances along u, in metres; fewer than 2^31.
struct PlacesAlong {
  double begin_m, step_m;
  std::size_t count;
  // Processors make numbers of 32 bits floating several at once, those of 64 not even one.
  double operator[](std::size_t i) const { return begin_m + static_cast<std::int32_t>(i) * step_m; }
};

/// In the profile frame, one value a place.
struct HeightsAlong {
  std::vector<double> z_m;            ///< NaN where no ground is
  std::vector<std::uint8_t> is_level; ///< of a triangle of the set
};

/// One of several profiles that are asked at a time.
struct AskedProfile {
  double depth_m;
  PlacesAlong at;
  HeightsAlong* heights; ///< what comes back
};

/// Whether heights_along has those of a grid: on a map plane always, in degrees where cells are
/// small and the grid isn't a continent.
bool has_heights_along(const Grid& grid);

/// Of a grid's triangles. On a map plane to rounding those of a profile's cut, less the sag of a
/// curved frame within a cell, for some 10 ns a place, whatever the size of cells. In degrees
/// within a metre along the ground of them, for some 30 ns, or half of it where four profiles are
/// asked at a time.
/// REQUIRES has_heights_along(grid).
void heights_along(const Grid& grid, const View& view, const TriangleSet& level,
                   std::span<const AskedProfile> profiles);

/// Those of a profile that has been cut.
void heights_along(const Profile& profile, const PlacesAlong& at, HeightsAlong& out);

} // namespace orograph
