// SPDX-License-Identifier: GPL-3.0-or-later
// One surface of patches of different levels.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/departure.hpp"
#include "dem/levels/patch_heights.hpp"
#include "dem/levels/patches.hpp"
#include "dem/tin.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace orograph {

struct Patchwork {
  Tin tin;
  std::vector<Departure> departures; ///< of each patch
  std::vector<double> heights_m;     ///< true ones, of its vertices
  /// The places of its vertices in cells of the finest level, as `Patches` has them.
  std::vector<std::array<std::int64_t, 2>> places;
};

/// A vertex that several patches have is as the coarsest of them has it; one that lies on an edge
/// of a coarser patch is on the straight line between that edge's ends, in the ground frame, and
/// parts the coarse triangle too. So each edge has its triangles on both sides. A triangle that
/// misses a height isn't there. `grid` tells where patches are: it, or a level of it, has the
/// corners of the grid that they part. Cost: some 0.5 us a vertex, and that of the source.
Patchwork patchwork(const Grid& grid, const Patches& patches, const PatchSource& source);

} // namespace orograph
