// SPDX-License-Identifier: GPL-3.0-or-later
// One sector with the horizon in one list, profile after profile: where profiles hide, and for
// those who watch the horizon.
#pragma once

#include "hidden_lines/instruments.hpp"
#include "hidden_lines/sector_in_work.hpp"

namespace orograph {

/// `surface`: whether the surface hides, not only the profiles. Of `instruments` it minds the
/// horizon's, and shows it to the observer behind each profile.
SectorParts list_pass(const SectorInWork& work, bool surface, const Instruments& instruments,
                      const LayOut& lay_out, const Show& show, Counts& counts,
                      StageSeconds& seconds);

} // namespace orograph
