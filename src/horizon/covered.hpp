// SPDX-License-Identifier: GPL-3.0-or-later
// What of each X a sheet seen so far covers: not all below a horizon, but bands of Y, since a ray
// that leaves a sheet at its border may meet it again.
#pragma once

#include "geometry/segment.hpp"
#include "horizon/compare.hpp"
#include "horizon/horizon.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// What an edge of a sheet is to a ray that meets it: the sheet's picture begins there, turns up or
/// down, or ends.
enum class SheetEnd { opens, turns, closes };

/// From one source up to another, both covered.
struct Band {
  Segment bottom, top;
  bool bottom_inked, top_inked; ///< a line is drawn along it
};

/// Between two abscissae the same bands everywhere, in order of Y and apart from each other.
struct CoveredCell {
  double x_begin, x_end;
  std::uint32_t first, count;   ///< of the block's bands
  std::uint32_t open;           ///< of these: the one that the sheet was last seen in
  double low, high;             ///< no band is beyond; falling: there is none
  double inner_low, inner_high; ///< the open band is at least from and to; falling: it isn't known
};

/// Shares of the way along a line, left to right.
struct Shares {
  double begin, end;
};

/// Takes a sheet's edges front to back and knows what it covers. Along a ray a sheet's picture goes
/// up where the eye sees its upper side, and down where it sees its underside; so from where it
/// opens to where it turns first, from there to the next turn, and so on, it covers all of Y. It is
/// enough to take the edges at which it does so. Heights are compared by sources, exactly.
class Covered {
public:
  /// Nothing is covered; `count` columns of X, equally wide in `core`, of which the first begins
  /// and the last ends with `range`. REQUIRES a finite core within the range.
  Covered(XRange core, XRange range, std::size_t count);

  /// Takes what of a source is between two abscissae. REQUIRES that all that it has in front of it
  /// on its rays was taken. Cost: the pieces of the columns in which it changes something; O(1)
  /// for a column where all of it is inside of the one band.
  void take(const Segment& source, double x_begin, double x_end, SheetEnd end, bool inked);

  /// Appends what of a line between two abscissae isn't covered, as shares of its way. What is tied
  /// with the end of a band is seen, unless a line is drawn there already.
  void add_seen(const Segment& line, double x_begin, double x_end, const TieTolerance& tolerance,
                std::vector<Shares>& seen) const;
  /// The same of a line straight away from the eye, up or down at the X of its source (x0 == x1);
  /// what is covered beside it on the left counts, or on the right.
  void add_upright_seen(const Segment& upright, bool left, std::vector<Shares>& seen) const;

  /// The upper ends of what is covered.
  Horizon top() const;

private:
  struct Column {
    double x_begin, x_end;
    std::vector<CoveredCell> cells;
    std::vector<Band> bands;
    bool is_one_band = false; ///< all cells are
    /// As in a cell, of all cells.
    double low = 0, high = 0, inner_low = 0, inner_high = 0;
    void find_bounds();
  };
  std::size_t column_at(double x) const;
  void take_in(Column& column, const Segment& source, double begin, double end, SheetEnd sheet_end,
               bool inked);
  void take_in(const Column& column, const CoveredCell& cell, const Segment& source, double begin,
               double end, SheetEnd sheet_end, bool inked);
  void add_cell(const CoveredCell& cell, std::span<const Band> bands);
  void add_cell(double begin, double end, std::span<const Band> bands, std::uint32_t open);

  double x_begin_, columns_per_x_;
  std::vector<Column> columns_;
  Column next_;                ///< scratch
  std::vector<double> breaks_; ///< scratch
  std::vector<Band> bands_;    ///< scratch
};

} // namespace orograph
