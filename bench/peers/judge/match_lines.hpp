// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the lines a piece of ink draws, and whether the line is visible there.
#pragma once

#include <cstdint>

#include "fit_drawing.hpp"

namespace orograph {

struct InkCounts {
  std::uint64_t asked = 0;     ///< places on ink that isn't upright, evenly by length
  std::uint64_t hidden = 0;    ///< on a line, but hidden by more than the tolerance
  std::uint64_t unmatched = 0; ///< on no line
  std::uint64_t visible = 0;   ///< places on lines, visible by more than the tolerance
  std::uint64_t missing = 0;   ///< of these, without ink
  double hidden_share() const; ///< of the ink that is on a line
  double missing_share() const;
};

/// Asks about `count` places of the ink and as many of the lines, by the ray walk. A place of the
/// ink counts as right where any of the lines that it may draw is visible within `tolerance_mm`
/// there; it may draw those that the ink keeps to within the tolerance, for as long as the stroke
/// goes on in one direction, up to 16 columns to either side.
InkCounts match_lines(const ProfileLines& lines, const PlacedDrawing& drawing, double tolerance_mm,
                      std::uint64_t count);

} // namespace orograph
