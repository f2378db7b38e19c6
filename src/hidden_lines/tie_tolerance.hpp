// SPDX-License-Identifier: GPL-3.0-or-later
// The visibility tolerance, from the page to the visibility plane.
#pragma once

#include "horizon/compare.hpp"

#include "placing/placed_view.hpp"

namespace orograph {

/// `mm` on the page as differences of Y, for what the page shows of a sector.
TieTolerance tie_tolerance(const Sector& sector, double mm);

} // namespace orograph
