// SPDX-License-Identifier: GPL-3.0-or-later
// An order in which many vertices are added to a triangulation cheaply.
#pragma once

#include "dem/approximate/lattice_triangulation.hpp"

#include <vector>

namespace orograph {

/// Rounds, each of about twice as many vertices as the one before and drawn as if by lot, and
/// within a round near ones after each other (biased randomized insertion order: Amenta, Choi and
/// Rote 2003). The same order on every machine.
std::vector<LatticePoint> insertion_order(const std::vector<LatticePoint>& points);

} // namespace orograph
