// SPDX-License-Identifier: GPL-3.0-or-later
// Where the terrain ends against what is behind it (docs/how-it-works.md).
#pragma once

#include "dem/surface.hpp"
#include "profiles/seen_ground.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// The edges between a triangle that the eye sees, on the nearer side, and one turned away from it,
/// on the farther side, in order. Facing is the sign of N . (E - P); zero counts as turned away.
/// Where a sign is within its rounding bound (profiles/facing.hpp) both cases are taken as
/// possible, so that no silhouette is missed: an edge more hides nothing that isn't hidden. A grid
/// and the TIN of its triangles have the same.
/// Of a grid only those inside ground that is looked at, if it is told what is.
/// Cost: one pass over the triangles, a few flops each.
std::vector<SurfaceEdge> silhouette_edges(const Grid& grid, const View& view,
                                          const SeenGround* ground = nullptr);
std::vector<SurfaceEdge> silhouette_edges(const Tin& tin, const View& view);
std::vector<SurfaceEdge> silhouette_edges(const Surface& surface, const View& view,
                                          const SeenGround* ground = nullptr);

/// About how many there are for each cell, told from every 32nd row of cells.
double silhouettes_a_cell(const Grid& grid, const View& view);

/// The same edges as marks, a byte for each cell, by strips of cells: rows, or columns. A cell's
/// edges are those at its north-western vertex.
struct SilhouetteMarks {
  /// To the next vertex along the strip, to the one in the next strip, and to that behind it.
  static constexpr std::uint8_t kAlong = 1, kUpright = 2, kDiagonal = 4;

  bool rows_are_strips;
  std::size_t cells;               ///< in a strip
  std::vector<std::uint8_t> marks; ///< strip after strip

  std::span<const std::uint8_t> of_strip(int strip) const {
    return {&marks[static_cast<std::size_t>(strip) * cells], cells};
  }
};

/// Cost: as of `silhouette_edges`.
SilhouetteMarks silhouette_marks(const Grid& grid, const View& view, bool rows_are_strips,
                                 const SeenGround* ground = nullptr);

} // namespace orograph
