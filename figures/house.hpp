// SPDX-License-Identifier: GPL-3.0-or-later
// A small house: what the pictures of the view pipeline look at.
#pragma once

#include "geometry/vec.hpp"

#include <array>
#include <vector>

namespace orograph {

/// Three corners of a face, counterclockwise for who looks at it from outside.
using Face = std::array<Vec3, 3>;

/// A line of the house. It lies on two faces, or on one (a door's edge) that is named twice.
struct HouseLine {
  Vec3 from, to;
  std::array<std::size_t, 2> faces;
};

struct House {
  std::vector<Face> faces;
  std::vector<HouseLine> lines;
};

/// 8 m wide (x from 0), 12 m long (y from 0, to the north), 5 m to the eaves and 8 m to the ridge
/// that runs along it, with a door and a window in the southern gable and three windows in the
/// eastern wall. Convex, so a line shows where one of its faces does.
House house();

} // namespace orograph
