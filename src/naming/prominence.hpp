// SPDX-License-Identifier: GPL-3.0-or-later
// How far one has to go down from a summit to reach higher ground.
#pragma once

#include "dem/surface.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Of a vertex: its height above the highest pass to higher ground, of all that is there.
struct Prominence {
  double m = 0; ///< 0 where the vertex is no summit
  /// Where going down to the pass meets the terrain's border, or a void, first: what is beyond may
  /// be higher, so the prominence is at least what lies above that place.
  bool is_at_least = false;
};

/// Of each of these vertices, on the surface as its edges join it; of several of one height the
/// lowest number counts as the highest. REQUIRES vertices with heights, and of a TIN that it is on
/// a map plane. Cost: one pass over the surface on all cores, and sorting what of it are passes,
/// some 15 ns a vertex of a grid on two cores; of a TIN sorting its edges.
std::vector<Prominence> prominences(const Surface& surface,
                                    std::span<const std::uint32_t> vertices);

} // namespace orograph
