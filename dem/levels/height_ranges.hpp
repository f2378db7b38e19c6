// SPDX-License-Identifier: GPL-3.0-or-later
// How low and how high the ground of parts of a grid is.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/patches.hpp"

#include <limits>
#include <utility>
#include <vector>

namespace orograph {

/// Of heights; low_m above high_m where there are none.
struct PartHeights {
  double low_m = std::numeric_limits<double>::infinity(), high_m = -low_m;

  bool empty() const { return !(low_m <= high_m); }
  void include(const PartHeights& other);
};

/// Kept for squares of kPatchCells cells. Cost: one pass over the heights on all cores.
class HeightRanges {
public:
  explicit HeightRanges(const Grid& grid);
  /// Found before, of a grid of so many columns; row-major.
  HeightRanges(int columns, std::vector<PartHeights> squares)
      : across_((columns - 2) / kPatchCells + 1), tiles_(std::move(squares)) {}

  /// Of the squares that have a share in a part.
  PartHeights of(const PatchPlace& part) const;

private:
  int across_;
  std::vector<PartHeights> tiles_; ///< row-major
};

} // namespace orograph
