// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing's strokes to the pens that draw them.
#pragma once

#include "draw/drawing.hpp"
#include "draw/pen.hpp"
#include "geometry/api.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

struct Dash {
  double dash_mm = 0, gap_mm = 0; ///< above 0
};

/// A pen, and what it draws.
struct PenOfLayers {
  Pen pen;
  /// By their names; none: those that no other pen names. With a field, none are all.
  std::vector<std::string> layers = {};
  /// Of their strokes those alone that are lines of features of which this field has one of the
  /// values, as text; empty: all. Letters' case tells fields not apart, but values.
  std::string field = {};
  std::vector<std::string> values = {};
  std::optional<Dash> dash = {};
  std::string place = {}; ///< for messages: "pens.toml, line 3"
};

/// Of those pens, in their order, that draw a layer whatever its features.
OROGRAPH_API std::vector<Pen> pens_of(std::string_view layer, std::span<const PenOfLayers> pens);

/// What becomes of strokes that no pen draws.
enum class WithoutPen {
  refused, ///< a UsageError: they would be missed when the map is plotted
  kept     ///< in their layers, beneath those of pens, as a picture may have them
};

/// Makes one layer for each pen that has something to draw, in the pens' order: it has the pen's
/// name, or "pen 3", and its width. A stroke goes to a pen with a field that its feature meets, or
/// else to one that names its layer, or else to one without layers; of several to the one whose
/// width is nearest to its own, by their ratio. Dashes are strokes of their own, of lines that
/// touch as one. What shows a pen's way stays, as the last layer. Throws UsageError for a field
/// that no feature of the layers may have, if there are any. REQUIRES strokes without map points,
/// on the page's step.
OROGRAPH_API void assign_pens(Drawing& drawing, std::span<const PenOfLayers> pens,
                              WithoutPen rest = WithoutPen::refused);

} // namespace orograph
