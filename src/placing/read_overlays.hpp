// SPDX-License-Identifier: GPL-3.0-or-later
// Overlays for a terrain.
#pragma once

#include "dem/overlay.hpp"
#include "dem/read/read_overlay.hpp"
#include "dem/terrain.hpp"

#include <span>
#include <vector>

namespace orograph {

/// As `read_overlay`, each. Throws Error where there is no terrain to lay them on.
std::vector<Overlay> read_overlays(std::span<const OverlayInput> inputs,
                                   const TerrainData& terrain);

} // namespace orograph
