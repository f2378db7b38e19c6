// SPDX-License-Identifier: GPL-3.0-or-later
// From a body as it is described, by the polygons that bound it, to a solid.
#pragma once

#include "geometry/vec.hpp"
#include "solids/solid.hpp"

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

/// The polyhedron as a solid: its faces in triangles (a fan, or ears cut off where a face is not
/// convex), each edge once, with the triangles on either side, edges within a face smooth. Vertices
/// that no face has are left out, the others keep their order; edges come by `from`, then `to`,
/// with from < to.
///
/// Throws Error unless the polyhedron is one or several closed surfaces, each face outwards: a
/// coordinate is not finite or beyond 1e12 m; a face has fewer than three corners, a vertex that
/// isn't there, one twice, corners off its plane (by more than a millionth of the polyhedron's
/// size), or touches itself; an edge has not two faces, or two that run along it the same way; a
/// closed part has no volume or is inside out. Whether faces cross each other is not looked at.
/// Vertices and faces count from 0 in messages.
///
/// Cost: as sorting the edges; of a face that is not convex the square of its corners.
Solid build_solid(const Polyhedron& polyhedron);

/// Wires alone: they hide nothing. Throws Error: a coordinate as above; a line that has no length
/// or names a vertex that isn't there.
Solid build_wires(const std::vector<Vec3>& vertices_m,
                  const std::vector<std::array<std::uint32_t, 2>>& lines);

} // namespace orograph
