// SPDX-License-Identifier: GPL-3.0-or-later
// Overlapping triangles, cut where one comes out from under another.
#pragma once

#include "dem/mesh/common_ground.hpp"
#include "dem/mesh/piece_vertices.hpp"
#include "dem/tin.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

struct UpperPiece {
  std::uint32_t of = 0; ///< the triangle that it is part of
  std::array<std::uint32_t, 3> triangle;
};

struct UpperPieces {
  std::vector<Vec3> vertices_m;   ///< the Tin's, and new ones after them
  std::vector<UpperPiece> pieces; ///< by `of`; a triangle that stays whole is its own piece
  std::vector<PlanEdge> split;    ///< edges of chosen triangles that got points, in order
};

/// What is highest of the chosen triangles (in ascending order), cut along their edges and the
/// lines where they pierce each other (`grounds`), as far as those are seen. What is under
/// triangles that stay `whole` (in ascending order too) is left out. Of heights within
/// `tolerance_m` of each other the one of the triangle of lower number counts.
UpperPieces cut_to_upper(const Tin& tin, std::span<const std::uint32_t> chosen,
                         std::span<const std::uint32_t> whole,
                         std::span<const CommonGround> grounds, double tolerance_m);

/// The edges of triangles, each once, in order.
std::vector<PlanEdge> edges_of(const Tin& tin, std::span<const std::uint32_t> triangles);

} // namespace orograph
