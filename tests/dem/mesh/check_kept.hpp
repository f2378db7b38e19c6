// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of a surface between planes, against its definition: each triangle of the surface
// cut by each plane, in long double.
#pragma once

#include "dem/mesh/half_space.hpp"
#include "dem/tin.hpp"
#include "tests/support/random.hpp"

#include <cstddef>
#include <span>

namespace orograph {

/// What a test has looked at.
struct KeptSums {
  std::size_t scenes = 0, kept = 0, cut = 0, asked = 0, within = 0, walls = 0;
};

/// Validity, areas in plan and in space, heights at random points, where new border lies, and that
/// what isn't cut is as it was.
void check_kept(const Tin& tin, const Tin& kept, std::span<const HalfSpace> spaces, Random& random,
                KeptSums& sums);

} // namespace orograph
