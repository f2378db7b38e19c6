// SPDX-License-Identifier: GPL-3.0-or-later
// Dashes as strokes of their own, so that a plotter draws them too.
#pragma once

#include "draw/drawing.hpp"

namespace orograph {

/// The layer with each stroke cut into dashes, from one of its ends to the other: as many whole
/// ones as fit, dash and gap stretched together so that it begins and ends with a dash. A stroke
/// that is shorter than a dash and a gap stays whole. REQUIRES a layer without map points, and
/// lengths above 0.
Layer dashed(const Layer& layer, double dash_mm, double gap_mm);

} // namespace orograph
