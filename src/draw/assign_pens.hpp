// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing's strokes to the pens that draw them.
#pragma once

#include "draw/drawing.hpp"
#include "draw/pen.hpp"
#include "geometry/api.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// A pen, and which layers it draws, by their names; none: those that no other pen names.
struct PenOfLayers {
  Pen pen;
  std::vector<std::string> layers = {};
};

/// Of those pens, in their order, that draw a layer.
OROGRAPH_API std::vector<Pen> pens_of(std::string_view layer, std::span<const PenOfLayers> pens);

/// Makes one layer for each pen that has something to draw, in the pens' order: it has the pen's
/// name, or "pen 3", and its width. Of several that draw a layer a stroke goes to the one whose
/// width is nearest to its own, by their ratio. What shows a pen's way stays, as the last layer.
/// Throws UsageError where no pen draws a layer that has strokes. REQUIRES strokes without map
/// points.
OROGRAPH_API void assign_pens(Drawing& drawing, std::span<const PenOfLayers> pens);

} // namespace orograph
