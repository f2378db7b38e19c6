// SPDX-License-Identifier: GPL-3.0-or-later
// One sector with the surface as occluder: all its profiles and lines, in strips of X on all cores.
#pragma once

#include "hidden_lines/sector_in_work.hpp"

namespace orograph {

/// Profiles are cut, clipped strip by strip, and laid out, a batch of them after another, on all
/// threads that the caller's arena has. The result is the same with any number of threads. Seconds
/// of the stages are those of all threads together.
SectorParts strips_pass(const SectorInWork& work, const LayOut& lay_out, const Show& show,
                        Counts& counts, StageSeconds& seconds);

} // namespace orograph
