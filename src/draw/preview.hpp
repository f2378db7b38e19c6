// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing in small, for screens that show many.
#pragma once

#include "draw/drawing.hpp"

#include <string>
#include <vector>

namespace orograph {

struct PreviewLayer {
  std::string name;
  double pen_mm = 0, grey = 0;
  std::string colour; ///< "#rrggbb", instead of the grey; empty: none
  /// Moves and lines of SVG path data in whole tenths of a millimetre, relative but for the first:
  /// "m120 340l3-2 4 1m…".
  std::string path;
};

struct Preview {
  double width_mm = 0, height_mm = 0;
  std::vector<PreviewLayer> layers;
};

/// Some 30 kB at most, however large the drawing: every so many profiles, all other lines as far as
/// they fit, with the points that a screen shows.
Preview preview_of(const Drawing& drawing);

} // namespace orograph
