// SPDX-License-Identifier: GPL-3.0-or-later
// Heights for the points where triangles are cut.
#pragma once

#include "dem/mesh/neighbours.hpp"
#include "dem/tin.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

using PlanEdge = std::array<std::uint32_t, 2>; ///< two vertices, the lower one first

inline PlanEdge edge_of(const std::array<std::uint32_t, 3>& triangle, std::uint32_t side) {
  const auto [a, b] = ends_of(triangle, side);
  return a < b ? PlanEdge{a, b} : PlanEdge{b, a};
}

/// A part of a triangle, by points of the plane.
struct PlanPiece {
  std::uint32_t of = 0; ///< the triangle
  std::array<std::uint32_t, 3> points;
};

struct PieceVertices {
  std::vector<Vec3> vertices_m;                        ///< the Tin's, and new ones after them
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< the pieces, by vertices
};

/// At a point a piece has its triangle's own vertex, if one is there; else the height of the
/// triangle's edge that is said to go through the point (`edges_at`, for each point), so that two
/// neighbours have the same; else that of its plane. Heights at a point that are within
/// `tolerance_m` are one vertex, except for different vertices of the Tin.
PieceVertices give_heights(const Tin& tin, std::span<const PlanPiece> pieces,
                           std::span<const Vec2> points,
                           std::span<const std::vector<PlanEdge>> edges_at, double tolerance_m);

} // namespace orograph
