// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn instead of a file's own surface, and how far it is from that.
#pragma once

#include <cstddef>

namespace orograph {

/// A pen's line: a summit that far from its true place on the page is counted as moved.
constexpr double kSummitMoved_mm = 0.3;

struct LevelOfDetail {
  double step = 1;      ///< of the file's cells to one that is drawn; 0.5 halves them; the least
  double most_step = 1; ///< of patches; else the same
  double cell_m = 0, cell_mm = 0;   ///< on the ground; on the page at most
  double greatest_m = 0, rms_m = 0; ///< departure of heights from the file's: at most, where they
                                    ///< were read in larger cells already
  /// On the page where the ground is nearest; of patches where each is, but for the eye's feet.
  double greatest_mm = 0;
  std::size_t summits = 0;    ///< of the ten highest, those on the page
  double summit_moved_mm = 0; ///< on the page, at most of these
  /// How many of these are farther than `kSummitMoved_mm` from their true place on the page.
  std::size_t summits_moved = 0;
};

} // namespace orograph
