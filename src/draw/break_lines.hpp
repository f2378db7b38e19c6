// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that end where a text stands on them.
#pragma once

#include "draw/drawing.hpp"
#include "geometry/vec.hpp"

#include <array>
#include <span>

namespace orograph {

/// Takes away what of a layer's strokes is inside of turned rectangles (their corners, one after
/// the other round them), and what is left of a stroke that is shorter than `min_stroke_mm`. Points
/// come on the page's step. Strokes that go through none stay as they are. REQUIRES a layer without
/// map points, on the page's step.
void break_lines(Layer& layer, std::span<const std::array<Vec2, 4>> boxes, double min_stroke_mm);

} // namespace orograph
