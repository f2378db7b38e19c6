// SPDX-License-Identifier: GPL-3.0-or-later
// Whether triangles share ground.
#pragma once

#include "dem/tin.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace orograph {

using TrianglePair = std::array<std::uint32_t, 2>; ///< by number, the lower one first

/// True for a vertical triangle: its vertices are on one line seen from above.
bool is_wall(const Tin& tin, std::uint32_t triangle);

/// The insides of two triangles meet, seen from above. Exact. REQUIRES that both run
/// counterclockwise.
bool overlap(const Tin& tin, std::uint32_t a, std::uint32_t b);

/// Two triangles that overlap, if any do; walls never do. REQUIRES finite coordinates; triangles
/// that are counterclockwise or walls; the right neighbours, running along edges the other way.
std::optional<TrianglePair> first_overlap(const Tin& tin);

/// Every pair of triangles that overlap. REQUIRES finite coordinates, and triangles that are
/// counterclockwise or walls; doesn't look at neighbours.
std::vector<TrianglePair> all_overlaps(const Tin& tin);

} // namespace orograph
