// SPDX-License-Identifier: GPL-3.0-or-later
// Which of overlapping triangles is the highest.
#pragma once

#include "dem/tin.hpp"

#include <span>
#include <vector>

namespace orograph {

/// For each point the triangle, among the chosen ones, that is highest there, its edges included;
/// kNoTriangle where there is none. Of heights within `tolerance_m` of each other the one of the
/// triangle that is chosen first counts.
std::vector<std::uint32_t> highest_triangles(const Tin& tin, std::span<const std::uint32_t> chosen,
                                             std::span<const Vec2> points, double tolerance_m);

} // namespace orograph
