// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "draw/colour.hpp"

#include <optional>
#include <string>

namespace orograph {

/// A plotter's pen: where it is held, what its ink is like, how it is led.
struct Pen {
  int number = 1; ///< of its holder, from 1
  std::string name = {};
  Colour colour{};
  double width_mm = 0;
  std::optional<double> speed_mm_s = {};     ///< none: the plotter's own
  std::optional<double> height_percent = {}; ///< while it draws, 0 to 100; none: the plotter's own
  bool waits = false;                        ///< until somebody has put it in
};

} // namespace orograph
