// SPDX-License-Identifier: GPL-3.0-or-later
// A Tin on one side of a plane, and where the plane meets its edges.
#pragma once

#include "dem/mesh/half_space.hpp"
#include "dem/mesh/neighbours.hpp"
#include "dem/tin.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// `keep_within` (keep_within.hpp) of one half-space. Vertices without a triangle are left out.
Tin cut_at_plane(const Tin& tin, const HalfSpace& space);

/// The greater of an edge's extents east and north.
double plan_length_m(const Tin& tin, const PlanEdge& edge);

/// What is nearer along the edge, seen from above, is one place.
double rounding_reach_m(const Tin& tin, const PlanEdge& edge);

/// A new vertex on an edge.
struct PointOnEdge {
  PlanEdge edge;
  double along = 0; ///< grows from the edge's first vertex to its last; no matter in what unit
  std::uint32_t vertex = 0;
};

/// Where a plane meets the edges of a Tin.
struct PlaneCrossings {
  std::vector<std::int8_t> side;    ///< of each vertex, the new ones too: -1 within, 0 on, 1 beyond
  std::vector<Vec3> new_vertices_m; ///< numbered after the Tin's
  std::vector<PointOnEdge> points;  ///< by edge, and along it
  std::vector<std::uint32_t> touched; ///< triangles with new vertices, in order

  /// Those on one edge.
  std::span<const PointOnEdge> on(const PlanEdge& edge) const;
};

/// An edge with an end on either side gets a vertex on the plane. Walls that share an edge which
/// isn't upright stand over one line: where the plane meets an edge of one of them, all their edges
/// get a vertex at that very place seen from above, and over their vertices too.
PlaneCrossings find_crossings(const Tin& tin, const HalfSpace& space);

} // namespace orograph
