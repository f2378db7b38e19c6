// SPDX-License-Identifier: GPL-3.0-or-later
// Strips of a lattice's cells on the earth, whose lines are curves on the map plane, in an order
// front to back (docs/lattice-order.md).
#pragma once

#include "dem/grid.hpp"
#include "geometry/profile_point.hpp"
#include "geometry/segment.hpp"
#include "profiles/eye_side.hpp"
#include "profiles/falling_runs.hpp"
#include "view/view.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace orograph {

/// What of a lattice a view looks at, ahead of a depth and in a range of X.
struct LookedAt {
  XRange range;
  double from_m;
};

/// Rows or columns of cells between lines of the lattice of which the eye is on one side, as far as
/// they are looked at: those with the eye on the side of higher numbers come first in number, then
/// those with it on the other side. So a ray meets each of them once at most, and strips outwards
/// from the eye. A strip's cells are a path, and come in any order that the sides of the edges
/// between them give: with rising numbers, but for runs that fall.
///
/// Ground that isn't there goes on as high as beside it.
class EarthStrips {
public:
  /// So many vertices of a line are bounded together.
  static constexpr int kBlock = 64;

  /// None if there is no such order. REQUIRES a grid on the earth of which no triangle is turned
  /// over. On all cores; 2 to 4 ns a vertex.
  static std::optional<EarthStrips> of(const Grid& grid, const View& view, const LookedAt& looked,
                                       bool are_rows);
  /// By rows or columns, rather those that the view crosses more steeply.
  static std::optional<EarthStrips> of(const Grid& grid, const View& view, const LookedAt& looked);

  bool are_rows() const { return are_rows_; }
  int strips() const { return lines_ - 1; }
  int cells() const { return vertices_ - 1; } ///< of a strip
  /// The strip that comes first, or -1 or the number of strips where the eye is beyond them.
  int own() const { return own_; }

  struct CellOfStrip {
    int strip, cell;
  };
  /// Of a triangle, by its number.
  CellOfStrip cell_of(std::uint32_t triangle) const {
    const std::uint32_t cell = triangle / 2;
    const auto row = static_cast<int>(cell / cells_in_row_),
               column = static_cast<int>(cell % cells_in_row_);
    return are_rows_ ? CellOfStrip{row, column} : CellOfStrip{column, row};
  }

  /// The place of a cell in its strip's order.
  std::uint32_t place(int strip, int cell) const { return falling_.place(strip, cell); }
  /// Whether of the cells at the upright before a cell the one with the higher number is in front.
  bool falls(int strip, int cell) const;
  /// Whether a cell's triangle on the left of its diagonal, columns east and rows south, is in
  /// front.
  bool is_lower_near(int column, int row) const;
  /// The same, told the diagonal's ends: the first in number, and the last.
  bool is_lower_near(ProfilePoint first, ProfilePoint last) const {
    const double left = way_to_left(view_, first, last);
    return lower_is_right_ ? left < 0 : left > 0;
  }

  struct Cells {
    int first = 0, end = 0;
    bool empty() const { return first >= end; }
  };
  /// What of a strip is looked at.
  Cells cells_of(int strip) const { return looked_at_[static_cast<std::size_t>(strip)]; }
  struct Depths {
    double nearest_m, farthest_m;
  };
  /// Between which it lies; of one that isn't looked at infinity and -infinity.
  Depths depths_of(int strip) const { return depths_[static_cast<std::size_t>(strip)]; }
  struct Shown {
    Cells cells;
    double nearest_m, farthest_m;
  };
  /// What of two lines and the cells between them, or one line twice, may be in a range of X:
  /// bounds.
  Shown shown(int line, int other, XRange range) const;

  /// Calls take(thing) with things at rising cells of a strip in the order of those.
  template <class Thing, class CellOf, class Take>
  void for_each_in_order(int strip, std::span<Thing> things, const CellOf& cell_of,
                         const Take& take) const {
    auto at = things.begin();
    for (const FallingRun& run : runs_of(strip)) {
      for (; at != things.end() && cell_of(*at) < run.first; ++at) take(*at);
      const auto begin = at;
      while (at != things.end() && cell_of(*at) <= run.last) ++at;
      for (auto back = at; back != begin;) take(*--back);
    }
    for (; at != things.end(); ++at) take(*at);
  }

  std::span<const FallingRun> runs_of(int strip) const { return falling_.of_strip(strip); }

private:
  // Of a line the vertices of what is looked at, and of those the ones ahead.
  struct Line {
    int first = 0, last = -1, first_ahead = 0, last_ahead = -1;
    bool rises = true; ///< in X
  };
  // Of so many vertices of a line, the last ones perhaps fewer.
  struct Block {
    double x; ///< of the first, where it is ahead
    float nearest_m, farthest_m;
  };
  friend class EarthStripsScan;
  EarthStrips(const Grid& grid, const View& view, const LookedAt& looked, bool are_rows);

  ProfilePoint vertex(int line, int at) const;
  ProfilePoint filled_vertex(int line, int at) const;
  double x_of(ProfilePoint p) const {
    return view_.is_perspective() ? p.u / p.v : p.u + p.v * view_.x_per_v;
  }
  // Of a line's vertices ahead the last that is `before` and the first that isn't, to a few: where
  // X is what is sought.
  template <class Before>
  std::pair<int, int> parting(int line, double sought, const Before& before) const;
  Cells shown_of_line(int line, XRange range) const;
  // Of what cells have of a line.
  Depths depths_of(int line, Cells cells) const;

  const Grid* grid_;
  View view_;
  LookedAt looked_;
  bool are_rows_;
  int lines_, vertices_, blocks_, own_ = -1;
  std::uint32_t cells_in_row_;
  bool lower_is_right_; ///< of its diagonal
  std::vector<Line> line_;
  std::vector<Cells> looked_at_; ///< by strip
  std::vector<Depths> depths_;
  std::vector<Block> block_; ///< line after line
  FallingRuns falling_;
};

} // namespace orograph
