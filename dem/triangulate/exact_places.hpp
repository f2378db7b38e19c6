// SPDX-License-Identifier: GPL-3.0-or-later
// Places on lines and in triangles, reckoned in rationals and then rounded.
#pragma once

#include "geometry/vec.hpp"

#include <array>

namespace orograph {

/// Where the lines through a and b and through c and d cross. REQUIRES that they aren't parallel.
Vec2 crossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// p as a share of the way from a to b. REQUIRES a and b different, p on the line through them.
double share_along(Vec2 a, Vec2 b, Vec2 p);

/// Shares s with p = a + s[0] (b - a) + s[1] (c - a). REQUIRES that a, b, c aren't on one line.
std::array<double, 2> shares_in(Vec2 a, Vec2 b, Vec2 c, Vec2 p);

} // namespace orograph
