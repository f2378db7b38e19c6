// SPDX-License-Identifier: GPL-3.0-or-later
// How large cells are to be at each place of a terrain that an eye stands over.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/height_ranges.hpp"
#include "dem/levels/patches.hpp"
#include "placing/cell_on_page.hpp"
#include "placing/placed_view.hpp"
#include "profiles/seen_ground.hpp"

#include <optional>

namespace orograph {

/// How large a metre is on the page at places of a grid, from an eye in the landscape.
class ScaleOnPage {
public:
  /// REQUIRES a perspective view or a panorama of that grid; both outlive this.
  ScaleOnPage(const Grid& grid, const PlacedView& placed);

  /// Millimetres for a metre at the nearest ground of a part, whichever way it is turned; infinite
  /// at the eye, 0 where the view doesn't show it.
  double mm_per_m(const PatchPlace& part) const;

private:
  bool is_shown(const PatchPlace& part) const;

  const Grid& grid_;
  const PlacedView& placed_;
  std::optional<SeenGround> seen_; ///< none: all may be seen
  HeightRanges heights_;
  double mm_per_radian_; ///< in the picture's middle
};

/// Patches whose cells have such sizes on the page, halved three times at most, and less often
/// where that would be too many. `scale` is the grid's. Cost: some 100 ns a patch.
Patches patches_of_view(const Grid& grid, const ScaleOnPage& scale, const CellSizes& sizes);

} // namespace orograph
