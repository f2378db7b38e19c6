// SPDX-License-Identifier: GPL-3.0-or-later
// The points of an overlay, and nothing else of it.
#pragma once

#include "dem/overlay.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <vector>

namespace orograph {

/// A point for each that a feature has, and one without a place for a feature that has none.
struct OverlayPoints {
  std::vector<Vec2> places; ///< in map coordinates
  std::vector<std::size_t> feature_of;
  std::vector<std::size_t> place_of; ///< number of its place, or `kNone`
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
};

/// Throws Error where a feature is a line or an area, and where no point has a place.
OverlayPoints points_of(const Overlay& overlay);

} // namespace orograph
