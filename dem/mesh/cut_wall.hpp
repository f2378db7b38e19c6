// SPDX-License-Identifier: GPL-3.0-or-later
// An upright triangle on one side of a plane.
#pragma once

#include "dem/mesh/half_space.hpp"
#include "geometry/vec.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace orograph {

/// A place on the border of a wall.
struct WallPoint {
  Vec3 at_m;
  int side = 0; ///< of the plane: -1 within, 0 on it, 1 beyond
  std::uint32_t vertex = 0;
};

/// The part within, as upright triangles between neighbouring places seen from above, by vertex. A
/// triangle runs from its lower corner forth (east, or north along a meridian), up and back; the
/// other way round where `turned`. `border` holds the wall's vertices and all new ones on its
/// edges: one or two over each place, or three where an upright edge was cut. `new_vertex` gives
/// the number of a new one on the plane, inside of the wall.
std::vector<std::array<std::uint32_t, 3>>
cut_wall(const HalfSpace& space, std::vector<WallPoint> border, bool turned,
         const std::function<std::uint32_t(const Vec3&)>& new_vertex);

} // namespace orograph
