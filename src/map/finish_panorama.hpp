// SPDX-License-Identifier: GPL-3.0-or-later
// A panorama's strokes once all sectors have drawn theirs: joined where two sectors meet, and put
// into strips.
#pragma once

#include "draw/drawing.hpp"
#include "placing/panorama.hpp"

#include <span>

namespace orograph {

/// Joins strokes of one profile that end where two sectors meet, at the same place; those of one
/// width become one. What is shorter than `min_stroke_mm` from one of its ends to the other,
/// whatever its widths, is left out, and its length added to `left_out_mm`. REQUIRES strokes of
/// profiles, as sectors draw them: left to right, those of one run of a profile behind one another.
void join_at_borders(Layer& profiles, std::span<const Sector> sectors, double min_stroke_mm,
                     double& left_out_mm);

/// Each stroke cut where strips end, and moved to its strip.
Layer in_strips(const Layer& layer, std::span<const PanoramaStrip> strips);

} // namespace orograph
