// SPDX-License-Identifier: GPL-3.0-or-later
// The seed's method in exact rational arithmetic, to see what arithmetic in double costs.
#pragma once

#include "cli/draw_scene.hpp"
#include "cli/instruments.hpp"

namespace orograph {

/// What profiles alone hide, by `exact_clip`: told to the observer and counted, not drawn.
/// Memory: all projected profiles.
DrawnScene draw_exactly(const Terrain& terrain, const Scene& scene, LineObserver* observer);

} // namespace orograph
