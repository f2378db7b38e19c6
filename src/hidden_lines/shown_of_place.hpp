// SPDX-License-Identifier: GPL-3.0-or-later
// What of a place of the lattice's order a range of X shows.
#pragma once

#include "hidden_lines/lattice_in_work.hpp"

namespace orograph {

/// Bounds: nothing outside of them is shown, and all of it but a margin inside.
struct ShownOfPlace {
  double nearest_m = 0, farthest_m = 0;
  int first_cell = 0, end_cell = 0; ///< of the strip of cells, or along the line
  bool empty() const { return first_cell == end_cell; }
};

ShownOfPlace shown_of(const LatticeInWork& lattice, const LatticeOrder::Place& place, XRange range);

} // namespace orograph
