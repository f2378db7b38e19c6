// SPDX-License-Identifier: GPL-3.0-or-later
// An outline's short ways back: where the edge of what is seen turns under itself, it is no upper
// envelope, and yet the eye sees one line.
#pragma once

#include "draw/drawing.hpp"

namespace orograph {

/// Moves to `outline` the strokes of another layer that lead from one of its ends to another and
/// are at most `longest_mm` long. Ends meet that are a page step apart or less. Cost O(n log n).
/// REQUIRES that both have the same kinds of points beside those of the page, and no widths.
void close_outline(Layer& outline, Layer& other, double longest_mm);

} // namespace orograph
