// SPDX-License-Identifier: GPL-3.0-or-later
// The levels that contours are drawn at.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace orograph {

struct ContourLevels {
  std::vector<double> heights_m; ///< rising
  std::vector<double> heights;   ///< the same as asked for, in the unit that was asked for
  std::vector<bool> is_index;
  double low, high; ///< the ground's heights, in that unit
};

/// Those between the least and the greatest of a terrain's heights; on a block's walls from its
/// base on. Where `spec` has neither a list nor an interval there are some 25, or fewer: on a map
/// 250 mm wide they are 0.45 mm apart on the slopes that they lie on. Throws Error where there were
/// more than 10,000.
ContourLevels contour_levels(const TerrainData& terrain, const ContourSpec& spec,
                             std::optional<double> base_m = {});

/// The same where the least and the greatest height are known.
ContourLevels contour_levels(const TerrainData& terrain, std::pair<double, double> heights_m,
                             const ContourSpec& spec, std::optional<double> base_m = {});

/// The one of 1, 2 and 5 times powers of ten that is nearest, by ratio. REQUIRES a value above 0.
double round_step(double value);

} // namespace orograph
