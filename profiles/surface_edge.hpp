// SPDX-License-Identifier: GPL-3.0-or-later
// Names for the edges of a surface's triangles.
#pragma once

#include <compare>
#include <cstdint>

namespace orograph {

/// An edge of the triangulation, from the vertex of lower index to the higher. Points on it are
/// always reckoned in this direction, so that they are the same numbers everywhere, and the same
/// for a grid and the TIN of its triangles.
struct SurfaceEdge {
  std::uint32_t from, to; ///< vertex indices, from < to
  auto operator<=>(const SurfaceEdge&) const = default;
};

} // namespace orograph
