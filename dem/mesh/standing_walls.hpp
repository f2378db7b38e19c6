// SPDX-License-Identifier: GPL-3.0-or-later
// Which walls still fit a surface that has been changed.
#pragma once

#include "dem/tin.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace orograph {

/// A triangle had something beside it at the side opposite to vertex k.
using HadBeside = std::array<bool, 3>;

/// Takes walls away until the rest fit: none stands at an edge of three, has lost what it had
/// beside it at an edge that isn't upright, or runs along an edge as its neighbour does. Gives the
/// others their direction and all triangles their neighbours. `had` has an entry for each triangle;
/// only those of walls are looked at. Returns how many were taken away. REQUIRES that triangles
/// other than walls fit each other.
std::size_t keep_standing_walls(Tin& tin, std::vector<HadBeside> had);

} // namespace orograph
