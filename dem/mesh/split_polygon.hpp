// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a polygon that is convex but for rounding.
#pragma once

#include "geometry/vec.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Corners of a triangle, by their place in the polygon.
using PolygonTriangle = std::array<std::uint32_t, 3>;

/// Of all ways to split the polygon the one whose thinnest triangle is the thickest, all of them
/// counterclockwise, exactly; nothing where there is no such way. Of equals the first. REQUIRES 3
/// corners or more that run counterclockwise. Cost O(n^3) for n corners: meant for few.
std::vector<PolygonTriangle> split_polygon(std::span<const Vec2> corners);

} // namespace orograph
