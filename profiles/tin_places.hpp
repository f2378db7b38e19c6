// SPDX-License-Identifier: GPL-3.0-or-later
// What many cutters of a TIN, each for a view of its own, would find again and again.
#pragma once

#include "dem/tin.hpp"
#include "profiles/mesh.hpp"
#include "profiles/triangles.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// The same for all views of a TIN. Memory: 8 bytes a side of the border, and 16 a triangle.
struct TinPlaces {
  std::vector<TinSide> border;                 ///< sides with nothing beyond them
  TriangleSet walls;                           ///< as `walls_of` has them
  std::vector<std::uint32_t> begin, triangles; ///< at vertex i: [begin[i], begin[i + 1])

  std::span<const std::uint32_t> at_vertex(std::uint32_t vertex) const {
    return std::span(triangles).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
  }
};

/// Cost: three passes over the triangles.
TinPlaces tin_places(const Tin& tin);

} // namespace orograph
