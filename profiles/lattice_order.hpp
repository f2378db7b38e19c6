// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which the triangles and edges of a grid may hide each other: that of its own rows
// and columns, outwards from the eye (docs/lattice-order.md).
#pragma once

#include "dem/grid.hpp"
#include "profiles/earth_strips.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <cstdint>

namespace orograph {

/// Where the eye is on the ground, in cell coordinates: columns east and rows south of the grid's
/// first vertex; in a parallel view a direction to it.
struct EyeInCells {
  double column, row, height; ///< the height before exaggeration
};
EyeInCells eye_in_cells(const Grid& grid, const View& view);

/// Every triangle and every edge has a turn. What stands in front of something else along a ray has
/// the lesser turn; an edge's is between those of its two triangles. (An edge that runs along a
/// ray hides nothing; of several such edges of one lattice line those nearer to the eye come
/// first.)
///
/// Cells are taken strip by strip, rows or columns of cells, those nearer to the eye first, and
/// within a strip those nearer to the eye first. On the earth cells of a strip come in the order of
/// `EarthStrips`, and all are taken outwards.
class LatticeOrder {
public:
  /// Strips are the rows if `rows_are_strips`, otherwise the columns. The order is right with
  /// either; the one whose lines the view's rays cross more steeply makes shorter profiles wait.
  LatticeOrder(int columns, int rows, const EyeInCells& eye, bool is_parallel,
               bool rows_are_strips);
  /// Takes the better one. REQUIRES a grid on a map plane.
  LatticeOrder(const Grid& grid, const View& view);
  /// REQUIRES that the strips outlive it.
  explicit LatticeOrder(const EarthStrips& strips);

  using Turn = std::uint64_t;
  Turn turn(SurfaceEdge edge) const;
  Turn turn(int column, int row, Half half) const;
  /// Of the nearer triangle of a cell: its strip, and its number in that.
  Turn turn_of_nearer(int strip, int cell) const {
    return turn_at(strips_.place_of_cell(strip), place_of_cell(strip, cell), Step::near);
  }

  /// Of the farther one, from that.
  static Turn turn_of_farther(Turn nearer) {
    return nearer + static_cast<Turn>(Step::far) - static_cast<Turn>(Step::near);
  }

  bool rows_are_strips() const { return rows_are_strips_; }
  /// Whether the lower triangle of a cell is in front of its diagonal.
  bool is_lower_near(int column, int row) const {
    return earth_ ? earth_->is_lower_near(column, row)
                  : eye_across_ < static_cast<double>(column - row);
  }
  /// None on a map plane.
  const EarthStrips* earth() const { return earth_; }

  /// A place in the order: first the edges along a line of the lattice, then what is in the strip
  /// of cells behind it. The eye's own strip comes without a line, a side's last line without a
  /// strip.
  struct Place {
    static constexpr int kNone = -1;
    int line, strip; ///< rows, or columns
  };
  std::uint32_t place_count() const { return strips_.place_count(); }
  Place place(std::uint32_t number) const;
  /// Whether strips are taken with rising numbers there.
  bool strips_rise(std::uint32_t place) const { return place < strips_.minus_place(); }
  /// From the first to the last place that holds something of the strips and lines between two
  /// rows, or columns.
  struct Places {
    std::uint32_t first, last;
  };
  Places places_between(int low, int high) const;
  static std::uint32_t place_of(Turn turn) {
    return static_cast<std::uint32_t>(turn >> kPlaceBits);
  }
  static bool is_on_line(Turn turn) { return ((turn >> kInsideBit) & 1U) == 0; }

  /// Within a strip cells are taken from `first_outwards` on with rising numbers, then those before
  /// it with falling ones.
  int first_outwards() const { return cells_.first_plus; }
  /// Whether the line between a cell and the one before it is taken with rising numbers.
  bool is_outwards(int line) const { return line > cells_.eye; }
  bool goes_back(Turn turn) const { return !earth_ && cell_place(turn) >= cells_.minus_place(); }
  /// Of what is in a strip: the place of its cell in the strip's order.
  static std::uint32_t cell_place(Turn turn) {
    return static_cast<std::uint32_t>(turn >> kStepBits & kCellMask);
  }
  static bool is_upright(Turn turn) { return step(turn) == Step::upright; }
  /// Of what is in a strip: whether it is a triangle's turn.
  static bool is_of_triangle(Turn turn) {
    return step(turn) == Step::near || step(turn) == Step::far;
  }
  static bool is_diagonal(Turn turn) { return step(turn) == Step::diagonal; }
  /// Of what is in a strip: whether it comes behind all of its cell.
  static bool is_behind_cell(Turn turn) { return step(turn) > Step::far; }

private:
  // Of cells in a row about the eye: places of the eye's own and of those with rising numbers, one
  // more for the line behind the last of them, then those of cells with falling numbers, and one
  // more. So what is in the eye's own cell comes before the lines on both sides of it.
  struct Outwards {
    double eye;      // in cells
    int count;       // cells
    int first_plus;  // the eye's own, or the first with rising numbers
    int first_minus; // the first with falling ones; -1: none

    std::uint32_t minus_place() const { return static_cast<std::uint32_t>(count - first_plus) + 1; }
    std::uint32_t place_count() const {
      return minus_place() + static_cast<std::uint32_t>(first_minus + 2);
    }
    std::uint32_t place_of_cell(int cell) const {
      return cell >= first_plus ? static_cast<std::uint32_t>(cell - first_plus)
                                : minus_place() + static_cast<std::uint32_t>(first_minus - cell);
    }
    // The cell behind a line has the line's place.
    std::uint32_t place_of_line(int line) const {
      return line > eye ? static_cast<std::uint32_t>(line - first_plus)
                        : minus_place() + static_cast<std::uint32_t>(first_minus + 1 - line);
    }
  };
  static Outwards outwards(double eye, int count);

  static constexpr unsigned kStepBits = 3, kInsideBit = 34, kPlaceBits = 35;
  static constexpr Turn kCellMask = (Turn{1} << (kInsideBit - kStepBits)) - 1;
  // On the earth both of a cell's uprights may be in front of it, or at the strip's ends behind.
  enum class Step : std::uint64_t {
    upright = 0,
    other_upright = 1,
    near = 2,
    diagonal = 3,
    far = 4,
    upright_behind = 5
  };
  static Step step(Turn turn) { return static_cast<Step>(turn & ((Turn{1} << kStepBits) - 1)); }
  static Turn turn_at(std::uint32_t place, std::uint32_t cell, Step step) {
    return (Turn{place} << kPlaceBits) | (Turn{1} << kInsideBit) | (Turn{cell} << kStepBits) |
           static_cast<Turn>(step);
  }
  std::uint32_t place_of_cell(int strip, int cell) const {
    return earth_ ? earth_->place(strip, cell) : cells_.place_of_cell(cell);
  }
  Turn turn_of_upright(int strip, int cell) const;

  std::uint32_t columns_;
  bool rows_are_strips_;
  const EarthStrips* earth_ = nullptr;
  double eye_across_ = 0;   ///< columns less rows
  Outwards strips_, cells_; ///< on the earth just the strips
};

} // namespace orograph
