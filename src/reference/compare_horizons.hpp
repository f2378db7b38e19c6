// SPDX-License-Identifier: GPL-3.0-or-later
// A horizon in double precision against the true one: whether it has the least size, ties apart.
#pragma once

#include "horizon/compare.hpp"
#include "horizon/horizon.hpp"

#include <cstddef>

namespace orograph {

/// Along X the two horizons are of one source, or they differ. A stretch where they differ is a
/// *tie* if its two sources lie within the visibility tolerance of each other all along, or if it
/// is no wider than rounding. Ends of pieces inside such stretches or at their ends may be more or
/// fewer than the true horizon's.
///
/// kept size + ties_fewer = true size + ties_more + marks + fragments; so a horizon without
/// fragments, whose stretches are all ties, has the least size, ties apart.
struct HorizonDifferences {
  std::size_t ties_more = 0;  ///< ends that ties add, over all stretches
  std::size_t ties_fewer = 0; ///< ends that ties take away
  std::size_t marks = 0;      ///< ends between a drawn and an undrawn part of one source: ties, too
  std::size_t fragments = 0;  ///< ends between parts of one source that nothing tells apart
  std::size_t stretches = 0;  ///< where the two differ, and not in rounding of an end alone
  std::size_t wrong = 0;      ///< of those, the ones that are no ties
  double farthest_mm = 0;     ///< the greatest difference in height, on the page, of a tie

  bool has_least_size() const { return fragments == 0 && wrong == 0; }
  HorizonDifferences& operator+=(const HorizonDifferences& other);
};

/// REQUIRES that `least` is `ExactHorizon::pieces` of the same sources.
HorizonDifferences compare_horizons(const Horizon& kept, const Horizon& least,
                                    const TieTolerance& tolerance);

} // namespace orograph
