// SPDX-License-Identifier: GPL-3.0-or-later
// A body as it is described: by the polygons that bound it.
#pragma once

#include "geometry/vec.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace orograph {

struct Polyhedron {
  std::vector<Vec3> vertices_m;
  /// Plane polygons, convex or not, their corners counterclockwise for who looks from outside.
  std::vector<std::vector<std::uint32_t>> faces;
  /// Edges of a curved surface, drawn only as its outline; in either direction.
  std::vector<std::array<std::uint32_t, 2>> smooth_edges;
};

} // namespace orograph
