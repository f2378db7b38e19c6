// SPDX-License-Identifier: GPL-3.0-or-later
// The visibility tolerance on a scene's page.
#pragma once

#include "cli/scene.hpp"
#include "horizon/compare.hpp"

namespace orograph {

/// `mm` on the page as differences of Y, for what the page shows of a sector.
TieTolerance tie_tolerance(const Sector& sector, double mm);

} // namespace orograph
