// SPDX-License-Identifier: GPL-3.0-or-later
// A triangulated irregular network: the terrain of a survey (docs/how-it-works.md).
#pragma once

#include "geometry/vec.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace orograph {

/// No triangle: beyond an edge of the border.
constexpr std::uint32_t kNoTriangle = 0xffffffff;

/// Triangles over the plane, in metres of the ground frame (true heights), whose origin is near the
/// terrain. Seen from above each triangle runs counterclockwise, no two overlap, and an edge has
/// one triangle or two. A vertical triangle (a wall) has no area seen from above; it runs as its
/// neighbours have it. Triangles may touch at a vertex only, parts may be apart, and there may be
/// holes. `verify` (dem/mesh/verify_tin.hpp) checks all of that.
///
/// An edge is reckoned from its vertex of lower index to the higher, as a Grid's is.
struct Tin {
  std::vector<Vec3> vertices_m;                         ///< finite
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertex indices
  std::vector<std::array<std::uint32_t, 3>> neighbours; ///< [t][k]: the triangle on the other side
                                                        ///< of the edge opposite to vertex k of t

  bool operator==(const Tin&) const = default;
};

} // namespace orograph
