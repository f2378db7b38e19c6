// SPDX-License-Identifier: GPL-3.0-or-later
// What of a sheet can be seen in a wedge of azimuths about an eye, as a panorama's sectors are.
#pragma once

#include "dem/surface.hpp"
#include "geometry/profile_point.hpp"
#include "profiles/sheet.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Clockwise from a frame's forward direction, radians; no more than half a turn.
struct AzimuthWedge {
  double begin, end;
};

/// Some of a sheet's triangles: of a grid the cells from one to another in each row, voids as well,
/// of a TIN any. Each has a place among them, in the order of their numbers.
class SheetPart {
public:
  /// All of them, each at the place of its number.
  explicit SheetPart(const SheetTriangles& triangles)
      : count_(static_cast<std::uint32_t>(triangles.count())) {}

  /// Cells of a row, `behind` not included.
  struct Cells {
    std::uint32_t first = 0, behind = 0;
    std::uint32_t place = 0; ///< of the first, among the part's cells
    bool has(std::uint32_t column) const { return column >= first && column < behind; }
  };

  bool is_all() const { return !is_part_; }
  std::uint32_t count() const { return count_; } ///< of places
  /// REQUIRES a part of a grid.
  const std::vector<Cells>& rows() const { return rows_; }

  /// kNoTriangle where it isn't among them.
  std::uint32_t place_of(std::uint32_t triangle) const {
    if (!is_part_) return triangle;
    if (rows_.empty()) {
      const auto at = std::ranges::lower_bound(listed_, triangle);
      return at != listed_.end() && *at == triangle
                 ? static_cast<std::uint32_t>(at - listed_.begin())
                 : kNoTriangle;
    }
    const std::uint32_t row = triangle / 2 / cells_, column = triangle / 2 - row * cells_;
    const Cells& of = rows_[row];
    return of.has(column) ? 2 * (of.place + column - of.first) + triangle % 2 : kNoTriangle;
  }

  /// Calls take(triangle, place) with those at places from `begin` to `end`.
  template <class Take>
  void for_each(std::uint32_t begin, std::uint32_t end, const Take& take) const {
    if (!is_part_ || rows_.empty()) {
      for (std::uint32_t i = begin; i < end; ++i) take(is_part_ ? listed_[i] : i, i);
      return;
    }
    auto row = std::ranges::upper_bound(rows_, begin / 2, {}, &Cells::place) - 1;
    for (std::uint32_t i = begin; i < end; ++row) {
      const std::uint32_t behind = 2 * (row->place + row->behind - row->first);
      const std::uint32_t first =
          2 * (static_cast<std::uint32_t>(row - rows_.begin()) * cells_ + row->first - row->place);
      for (; i < std::min(end, behind); ++i) take(first + i, i);
    }
  }

private:
  friend class PartsOfSheet;
  SheetPart() = default;

  bool is_part_ = false;
  std::uint32_t count_ = 0, cells_ = 1; ///< of a row of the grid
  std::vector<Cells> rows_;
  std::vector<std::uint32_t> listed_; ///< of a TIN, rising
};

/// For each wedge about the eye the triangles that reach into it; some that only come near as well.
/// REQUIRES a perspective view, in whose frame the eye is above the origin. Cost: a look at each
/// triangle.
std::vector<SheetPart> parts_in_wedges(const Surface& surface, const SheetTriangles& triangles,
                                       const View& view, std::span<const AzimuthWedge> wedges);

/// The vertices of a sheet in the frame of one view, kept as far as a part of it asks for them: for
/// who asks for each many times.
class PartVertices {
public:
  /// REQUIRES that surface and view outlive it. On all cores.
  PartVertices(const Surface& surface, const View& view, const SheetPart& part);

  ProfilePoint operator[](std::uint32_t vertex) const {
    if (tin_) return to_profile_frame(*view_, tin_->vertices_m[vertex]);
    const std::uint32_t row = vertex / columns_;
    return own_[rows_[row] + (vertex - row * columns_)];
  }

private:
  const Tin* tin_ = nullptr;
  const View* view_ = nullptr;
  std::uint32_t columns_ = 1;
  std::vector<std::ptrdiff_t> rows_; ///< to be added to a column
  std::vector<ProfilePoint> own_;
};

} // namespace orograph
