// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons in a plane: whether they are simple, and cutting them into triangles.
#pragma once

#include "geometry/vec.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace orograph {

/// A polygon that isn't convex takes time as the square of its corners.
constexpr std::size_t kMostCorners = 5000;

/// Positive where the corners run counterclockwise.
double signed_area(std::span<const Vec2> corners);

/// What keeps a line of straight pieces from being simple, as words that follow its name: corners
/// in one place, a turn back along itself, pieces that touch or cross. Empty: nothing. If `closed`,
/// a last piece leads back to the first corner. Directions that differ by less than 1e-12 are the
/// same. REQUIRES finite corners, at least two, three if closed.
std::string fault_of_line(std::span<const Vec2> corners, bool closed);

/// Triangles of three corners each, counterclockwise, that fill the polygon; every corner is one of
/// theirs and none has corners in a row. One less than two are there than corners; or none at all,
/// where rounding leaves no way. REQUIRES a simple polygon that runs counterclockwise.
std::vector<std::array<std::uint32_t, 3>> triangles_of(std::span<const Vec2> corners);

} // namespace orograph
