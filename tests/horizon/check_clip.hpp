// SPDX-License-Identifier: GPL-3.0-or-later
// What the clip's output must be, asked of its input by brute force: a drawn point is above every
// segment of every nearer list, a removed one is below one of them, and a tied one on it.
#pragma once

#include "geometry/homography.hpp"
#include "tests/horizon/flat_scenes.hpp"

#include <cstddef>

namespace orograph {

struct Tally {
  std::size_t asked = 0, ties = 0, wrong = 0, visible = 0, hidden = 0;
};

/// Clips all lists, front to back, as drawn occluders with a tolerance of `tolerance_mm` on `page`,
/// and asks each piece at its middle, just inside both ends and at ten random places. Counts as
/// ties, and doesn't judge, points within the tolerance (`greatest_y` at most) of what is in front.
Tally check_clip(const FlatScene& scene, double tolerance_mm, const Homography& page,
                 double greatest_y, std::uint64_t seed);

} // namespace orograph
