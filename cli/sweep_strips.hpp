// SPDX-License-Identifier: GPL-3.0-or-later
// One sector with the surface as occluder: all its profiles and lines, in strips of X on all cores.
#pragma once

#include "cli/sector_sweep.hpp"

namespace orograph {

/// Profiles are cut, clipped strip by strip, and laid out, a batch of them after another, on all
/// threads that the caller's arena has. The result is the same with any number of threads. Seconds
/// of the stages are those of all threads together.
SweptSector sweep_strips(const SectorInWork& work, const LayOut& lay_out, const Show& show,
                         CountsReport& counts, SecondsReport& seconds);

} // namespace orograph
