// SPDX-License-Identifier: GPL-3.0-or-later
<<<<<<< HEAD
// An order in which many vertices are added to a triangulation cheaply.
#pragma once

#include "dem/lattice_triangulation.hpp"

=======
// In which order a triangulation takes its places.
#pragma once

#include "geometry/vec.hpp"

#include <cstdint>
#include <span>
>>>>>>> 05555c7237a44eb17743dcbcea3a2ef224aaada9
#include <vector>

namespace orograph {

<<<<<<< HEAD
/// Rounds, each of about twice as many vertices as the one before and drawn as if by lot, and
/// within a round near ones after each other (biased randomized insertion order: Amenta, Choi and
/// Rote 2003). The same order on every machine.
std::vector<LatticePoint> insertion_order(const std::vector<LatticePoint>& points);
=======
/// The places' numbers: three that make a triangle first, then rounds that grow, so that inserting
/// takes O(n log n) steps or so wherever the places are. Near ones are near in a round if they are
/// in the list. Empty where all are on one line. REQUIRES places that are all different.
std::vector<std::uint32_t> insertion_order(std::span<const Vec2> places);
>>>>>>> 05555c7237a44eb17743dcbcea3a2ef224aaada9

} // namespace orograph
