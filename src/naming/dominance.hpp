// SPDX-License-Identifier: GPL-3.0-or-later
// How far a summit stands out above the ground on either side of it.
#pragma once

#include "dem/grid.hpp"
#include "dem/mesh/tin_index.hpp"
#include "dem/tin.hpp"
#include "geometry/vec.hpp"

#include <cstdint>

namespace orograph {

/// On the way to higher ground, and no farther.
constexpr double kDominanceReach_m = 3000;

/// A vertex's height above the higher of two lows: on both sides of it, along a direction on the
/// ground, the lowest vertex on the way to higher ground, within `kDominanceReach_m`. 0 where the
/// ground rises on one side at once. REQUIRES a vertex with a height and a unit vector. Cost: some
/// nanoseconds a cell on the way.
double dominance_m(const Grid& grid, std::uint32_t vertex, Vec2 across);
/// The same along the surface itself, up to where it ends. REQUIRES the index of that TIN, and a
/// vertex of a triangle. Cost: the triangles on the way, sorted.
double dominance_m(const Tin& tin, const TinIndex& index, std::uint32_t vertex, Vec2 across);

} // namespace orograph
