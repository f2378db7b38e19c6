// SPDX-License-Identifier: GPL-3.0-or-later
// Vertical triangles: which they are, which way they run, and which still fit a changed surface.
#pragma once

#include "dem/tin.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace orograph {

/// True for a vertical triangle: its vertices are on one line seen from above.
bool is_wall(const Tin& tin, std::uint32_t triangle);

/// The same of each triangle.
std::vector<std::uint8_t> are_walls(const Tin& tin);

/// Turns walls so that they run along edges the other way than their neighbours do; from walls
/// that stand beside triangles which aren't vertical the direction spreads to the walls beside
/// them. Where neighbours ask for different things one of them is followed; where no neighbour asks
/// for any, the wall of lowest number stays as it is. REQUIRES the right neighbours, which are kept
/// so.
void turn_walls(Tin& tin);

/// A triangle had something beside it at the side opposite to vertex k.
using HadBeside = std::array<bool, 3>;

/// Takes walls away until the rest fit: none stands at an edge of three, has lost what it had
/// beside it at an edge that isn't upright, or runs along an edge as its neighbour does. Gives the
/// others their direction and all triangles their neighbours. `had` has an entry for each triangle;
/// only those of walls are looked at. Returns how many were taken away. REQUIRES that triangles
/// other than walls fit each other.
std::size_t keep_standing_walls(Tin& tin, std::vector<HadBeside> had);

} // namespace orograph
