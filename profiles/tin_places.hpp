// SPDX-License-Identifier: GPL-3.0-or-later
// What many cutters of a TIN, each for a view of its own, would find again and again.
#pragma once

#include "dem/tin.hpp"
#include "geometry/box.hpp"
#include "profiles/mesh.hpp"
#include "profiles/triangles.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// The same for all views of a TIN. Memory: 40 bytes a side of the border, and 16 a triangle.
struct TinPlaces {
  /// With nothing beyond it.
  struct BorderSide {
    TinSide side;
    Vec2 from_m, to_m; ///< its ends, seen from above
  };
  static constexpr std::size_t kSidesTogether = 32;

  std::vector<BorderSide> border;
  std::vector<Box2> boxes_m; ///< of so many sides on end, which are near each other mostly
  TriangleSet walls;         ///< as `walls_of` has them
  std::vector<std::uint32_t> begin, triangles; ///< at vertex i: [begin[i], begin[i + 1])

  std::span<const BorderSide> sides_of(std::size_t box) const {
    const std::size_t first = box * kSidesTogether;
    return std::span(border).subspan(first, std::min(kSidesTogether, border.size() - first));
  }
  std::span<const std::uint32_t> at_vertex(std::uint32_t vertex) const {
    return std::span(triangles).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
  }
};

/// Cost: three passes over the triangles.
TinPlaces tin_places(const Tin& tin);

} // namespace orograph
