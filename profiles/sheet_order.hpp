// SPDX-License-Identifier: GPL-3.0-or-later
// The order of any surface's triangles front to back (docs/decisions/0054-both-sides.md).
#pragma once

#include "dem/surface.hpp"
#include "profiles/falling_runs.hpp"
#include "profiles/lattice_order.hpp"
#include "profiles/outline.hpp"
#include "profiles/sheet.hpp"
#include "profiles/sheet_part.hpp"
#include "profiles/sheet_vertices.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace orograph {

/// Strips of a lattice's cells, rows or columns, in an order in which what is in front along a ray
/// comes first, within each strip as well. Also where its lines are curves on the map plane.
struct StripsOfCells {
  bool are_rows, rises;
  std::uint32_t cells; ///< of a strip
  FallingRuns falling;
  /// By the cells' places in the part: whether the triangle on the left of the diagonal comes
  /// first.
  std::vector<std::uint8_t> upper_is_near;

  /// Of the cells of a part. None if the eye isn't on one side of all lines between strips; of all
  /// cells, if any is nearer than `from_m`. REQUIRES a grid on the earth.
  static std::optional<StripsOfCells> of(const Grid& grid, const SheetVertices& vertices,
                                         const SheetPart& part, const View& view, double from_m);

  std::uint32_t place(std::uint32_t column, std::uint32_t row) const; ///< of a cell
};

/// Gives every triangle of a part a place: what stands in front of another along a ray, with gaps
/// between them or not, has the lesser one. Of a grid on a map plane that is its turn in the
/// lattice's order, and of one on the earth strips of cells are taken in order where they have one.
/// Of others triangles are sorted by two relations: the one on the eye's side of a shared edge is
/// in front; and of two edges of the border that are next to each other on a ray with no ground
/// between them, the triangle at the nearer one is. Of triangles in a plane in front of the eye
/// these have no cycles; where rounding makes one, the nearest triangle goes first.
class SheetOrder {
public:
  /// `view` is a sector's; what is nearer than `from_m` isn't looked at. REQUIRES that the part
  /// outlives it. Cost of the last kind: O(triangles of the part + m log m) of its m edges of the
  /// border, and a look at all of those.
  SheetOrder(const Surface& surface, const SheetTriangles& triangles, const SheetPart& part,
             const std::vector<BorderEdge>& border, const View& view, double from_m);

  /// Of a triangle beside the part anything.
  std::uint64_t place(std::uint32_t triangle) const;

private:
  const SheetPart& part_;
  std::optional<LatticeOrder> lattice_;
  std::optional<StripsOfCells> strips_;
  std::uint32_t cells_ = 1;           ///< in a row of the lattice
  std::vector<std::uint32_t> places_; ///< of others, by place in the part
};

} // namespace orograph
