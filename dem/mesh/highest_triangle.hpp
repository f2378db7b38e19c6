// SPDX-License-Identifier: GPL-3.0-or-later
// Which of overlapping triangles is the highest.
#pragma once

#include "dem/mesh/plan_arrangement.hpp"
#include "dem/tin.hpp"

#include <span>
#include <vector>

namespace orograph {

/// For each face of the arrangement the triangle, among the chosen ones, that is highest in its
/// middle; only triangles that hold the whole face, but for `tolerance_m`, are asked. kNoTriangle
/// where there is none, or where a triangle of `whole` is over the middle, which has nothing over
/// it. Of heights within `tolerance_m` of each other the one of the triangle that
/// is chosen first counts.
std::vector<std::uint32_t> highest_triangles(const Tin& tin, std::span<const std::uint32_t> chosen,
                                             std::span<const std::uint32_t> whole,
                                             const PlanArrangement& arrangement,
                                             double tolerance_m);

} // namespace orograph
