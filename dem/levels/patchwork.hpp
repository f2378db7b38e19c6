// SPDX-License-Identifier: GPL-3.0-or-later
// One surface of patches of different levels.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/departure.hpp"
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

/// Patches of larger cells than the file's have its generalised heights, those of smaller ones its
/// refined heights. A vertex that several patches have is as the coarsest of them has it; one that
/// lies on an edge of a coarser patch is on the straight line between that edge's ends, in the
/// ground frame, and parts the coarse triangle too. So each edge has its triangles on both sides.
/// A triangle that misses a height isn't there. `is_kept` as of `generalised`; where it is empty,
/// larger cells aren't generalised but have the file's heights at their vertices. Cost: some 0.5 us
/// a vertex, and that of `HeightsOfPatches`.
Patchwork patchwork(const Grid& grid, const Patches& patches,
                    const std::function<bool(int column, int row)>& is_kept);

} // namespace orograph
