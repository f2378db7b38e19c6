// SPDX-License-Identifier: GPL-3.0-or-later
// Where a profile's line is drawn, and how wide.
#pragma once

#include <span>
#include <vector>

#include "tone/page_columns.hpp"
#include "tone/tone.hpp"

namespace orograph {

/// One line among all that could be drawn, a value a column.
struct LinePlace {
  int level;
  int halvings; ///< of the planned step, around it
  /// The distance of planned lines there is 2 to this in mm; NaN: it isn't seen.
  std::span<const float> planned_octave;
  std::span<const float> darkness; ///< empty without light
};

/// The runs of `toned_profiles`.
std::vector<ToneRun> runs_of_line(const LinePlace& line, const PageColumns& columns,
                                  const ToneRequest& request);

} // namespace orograph
