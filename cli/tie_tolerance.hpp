// SPDX-License-Identifier: GPL-3.0-or-later
// The visibility tolerance on a scene's page.
#pragma once

#include "cli/scene.hpp"
#include "horizon/compare.hpp"

namespace orograph {

/// `mm` on the page as differences of Y, for what the page shows.
TieTolerance tie_tolerance(const Scene& scene, double mm);

} // namespace orograph
