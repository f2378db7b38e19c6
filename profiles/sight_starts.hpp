// SPDX-License-Identifier: GPL-3.0-or-later
// Where a look from an eye comes into a surface: about the eye itself, and over the border, which
// is kept by direction.
#pragma once

#include "dem/grid.hpp"
#include "dem/tin.hpp"
#include "geometry/vec.hpp"
#include "profiles/mesh.hpp"
#include "profiles/outline.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Sides of triangles over which a look may come in from where there is no surface, by direction.
template <class Side>
struct SightStarts {
  std::vector<std::uint32_t> begin; ///< of the sides in bucket i; one more at the end
  std::vector<Side> sides;
  std::vector<decltype(Side::triangle)> under_eye; ///< all about it

  /// Those of the border that may be met in a direction, along u and v.
  std::span<const Side> towards(Vec2 direction) const;
  bool is_under_eye(const decltype(Side::triangle)& triangle) const;
};

/// Of a view whose profile frame is that of directions. `border` is `border_edges` of the surface;
/// what is no farther aside than `rounding_m` is met. Cost: O(border), of a TIN one pass over its
/// triangles.
SightStarts<GridSide> starts_of(const Grid& grid, std::span<const BorderEdge> border,
                                const View& view, double rounding_m);
SightStarts<TinSide> starts_of(const Tin& tin, const View& view, double rounding_m);

} // namespace orograph
