// SPDX-License-Identifier: GPL-3.0-or-later
// A surface as a thin sheet with an upper side and an underside: which of the two the eye sees of
// each triangle, and the edges where that changes.
#pragma once

#include "dem/surface.hpp"
#include "geometry/profile_point.hpp"
#include "profiles/eye_side.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace orograph {

/// A grid's or a TIN's triangles by number: `grid_triangle`, or that in the TIN.
class SheetTriangles {
public:
  /// REQUIRES that the surface outlives it. Cost of a TIN: its edges in order.
  explicit SheetTriangles(const Surface& surface);

  std::size_t count() const { return count_; } ///< of numbers, whether there is one or not
  bool is_there(std::uint32_t t) const { return there_.empty() || there_[t] != 0; }
  /// Counterclockwise, seen from above.
  std::array<std::uint32_t, 3> corners(std::uint32_t t) const {
    if (!grid_) return std::get<Tin>(*surface_).triangles[t];
    const auto cells = static_cast<std::uint32_t>(grid_->columns - 1),
               columns = static_cast<std::uint32_t>(grid_->columns);
    const std::uint32_t cell = t / 2, first = cell + cell / cells, across = first + columns + 1;
    const std::uint32_t beside = t % 2 == 0 ? first + columns : across,
                        last = t % 2 == 0 ? across : first + 1;
    return is_mirrored_ ? std::array{first, last, beside} : std::array{first, beside, last};
  }
  /// The triangle beyond the side opposite to corner k; kNoTriangle where there is none.
  std::uint32_t across(std::uint32_t t, std::size_t k) const;

  struct Sides {
    std::uint32_t left, right; ///< of from -> to, seen from above
  };
  Sides sides_of(SurfaceEdge edge) const;

private:
  std::uint32_t if_there(int column, int row, Half half) const;

  const Surface* surface_;
  const Grid* grid_;
  bool is_mirrored_ = false; ///< its lattice, seen from above
  std::size_t count_;
  std::vector<std::uint8_t> there_; ///< empty: all
  struct TinSides {
    SurfaceEdge edge;
    Sides sides;
  };
  std::vector<TinSides> edges_; ///< of a TIN, in order
};

/// A sheet as an eye sees it.
struct Sheet {
  SheetTriangles triangles;
  TriangleSet walls;               ///< vertical ones: beside one edge of theirs is what is below
                                   ///< it, beside another what is above
  std::vector<std::uint8_t> is_up; ///< by triangle: the eye is on its upper side
  /// Where along a ray the sheet's picture turns from up to down, and from down to up: the upper
  /// side ends there against what is behind it, and the underside. In order.
  std::vector<SurfaceEdge> ridges, valleys;
};

/// REQUIRES that the surface outlives it. Throws UsageError where a TIN has walls with gaps. Cost:
/// two passes over the triangles.
Sheet sheet_of(const Surface& surface, const View& view);

} // namespace orograph
