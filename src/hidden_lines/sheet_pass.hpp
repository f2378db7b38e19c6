// SPDX-License-Identifier: GPL-3.0-or-later
// One sector with the surface as a sheet with two sides, in strips of X on all cores.
#pragma once

#include "hidden_lines/counts.hpp"
#include "hidden_lines/sector_in_work.hpp"

namespace orograph {

/// As `strips_pass`, but that ground hides only what it covers, and each profile's runs are told
/// apart by the side of the sheet that they show. REQUIRES work.sheet.
SectorParts sheet_pass(const SectorInWork& work, const LayOut& lay_out, const Show& show,
                       Counts& counts, StageSeconds& seconds);

} // namespace orograph
