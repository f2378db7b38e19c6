// SPDX-License-Identifier: GPL-3.0-or-later
// Solids made for tests from plain lists; shares no code with src/solids/.
#pragma once

#include "solids/standing_solid.hpp"

#include <functional>
#include <string>
#include <vector>

namespace orograph {

/// Vertices and triangles while a solid is being made.
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// The solid of a closed surface, with its edges, each once: from the vertex of lower index. Within
/// a plane they are smooth. REQUIRES that every edge is run along once each way.
Solid solid_of(std::vector<Vec3> vertices_m, Triangles triangles);

/// Unit cells of a footprint, '#' in rows from the north, from height 0 to 1; its south-west corner
/// is the origin. Cells have a cell beside them, or are alone, but never touch at a corner only.
Solid made_cells(const std::vector<std::string>& rows);
Solid made_box(); ///< one cell
/// A star with `points` points about the z axis, radius 1 (0.4 between the points), height 0 to 1.
Solid made_star(int points);
/// Round, radius 1, height 0 to 1 (top radius 0: a cone to a tip), of `sides` sides between which
/// edges are smooth.
Solid made_round(int sides, bool cone);
/// Square base from (0, 0) to (1, 1), tip over its middle.
Solid made_pyramid();
Solid made_tetrahedron(); ///< the corner of a cube at the origin
/// A box with another, half as large, within it.
Solid made_nested();
/// Wires without a triangle: a mast, a yard across, two stays.
Solid made_wires();

/// `place` of each vertex. REQUIRES that the solid outlives it.
StandingSolid stand(const Solid& solid, bool mirrored, const std::function<Vec3(Vec3)>& place);

/// By the divergence theorem; negative where the triangles run clockwise seen from outside.
double volume_m3(const StandingSolid& standing);
/// How often a point off the surface is surrounded: the triangles' solid angles over the sphere's
/// (formula: van Oosterom and Strackee 1983).
double winding_number(const StandingSolid& standing, Vec3 point);

} // namespace orograph
