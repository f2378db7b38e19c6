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
enum class SheetEnd : std::uint8_t { opens, turns, closes };

/// From one source up to another, both covered; numbers of sources.
struct Band {
  std::uint32_t bottom, top;
};

/// Between two abscissae the same bands everywhere, in order of Y and apart from each other.
struct CoveredCell {
  double x_begin, x_end;
  std::uint32_t first, count;   ///< of the column's bands
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

  /// Reserves memory for so many sources, of which only what is used is paid for.
  void expect(std::size_t sources);

  /// Takes what of a source is between two abscissae. REQUIRES that all that it has in front of it
  /// on its rays was taken. Cost: the pieces of the columns in which it changes something; O(1)
  /// for a column where all of it is inside of the one band.
  void take(const Segment& source, double x_begin, double x_end, SheetEnd end, bool inked);

  /// Appends what of a line between two abscissae isn't covered, as shares of its way. What is tied
  /// with the end of a band is seen, unless a line is drawn there already. Tells whether all of it
  /// is within the bands that the sheet was last seen in: then to take it would change nothing.
  bool add_seen(const Segment& line, double x_begin, double x_end, const TieTolerance& tolerance,
                std::vector<Shares>& seen) const;
  /// The same of a line straight away from the eye, up or down at the X of its source (x0 == x1);
  /// what is covered at the abscissa `beside` counts, a little to its left or right.
  void add_upright_seen(const Segment& upright, double beside, std::vector<Shares>& seen) const;

  /// The upper ends of what is covered.
  Horizon top() const;

private:
  struct Source {
    Segment line;
    bool inked; ///< a line is drawn along it
  };
  // Bands of a cell never change: what does gets new ones behind the others, and now and then those
  // that are no cell's any more are left out.
  struct Column {
    double x_begin, x_end;
    std::vector<CoveredCell> cells;
    std::vector<Band> bands;
    bool is_one_band = false; ///< all cells are
    /// As in a cell, of all cells.
    double low = 0, high = 0, inner_low = 0, inner_high = 0;
    void find_bounds();
    std::size_t cell_at(double x) const; ///< the first that ends behind x, or their count
    std::span<const Band> bands_of(const CoveredCell& cell) const {
      return {bands.data() + cell.first, cell.count};
    }
  };
  std::size_t column_at(double x) const;
  std::uint32_t number_of(const Segment& source, bool inked);
  bool have_same_bands(const Column& column, const CoveredCell& a, const CoveredCell& b) const;
  void take_in(Column& column, const Segment& source, double begin, double end, SheetEnd sheet_end,
               bool inked);
  void take_in(Column& column, const CoveredCell& cell, std::uint32_t source, double begin,
               double end, SheetEnd sheet_end);
  void add_cell(const Column& column, const CoveredCell& cell);
  static void leave_out_unused(Column& column);
  bool add_seen_in(std::span<const Band> bands, std::uint32_t open, const Segment& line,
                   double begin, double end, Shares all, const TieTolerance& tolerance,
                   std::vector<Shares>& seen) const;
  void add_changed(Column& column, double begin, double end, std::uint32_t open);

  double x_begin_, columns_per_x_;
  std::vector<Column> columns_;
  std::vector<Source> sources_;      ///< of bands, in the order that they were taken
  std::vector<CoveredCell> changed_; ///< scratch: in the place of some of a column's
  std::vector<double> breaks_;       ///< scratch
  std::vector<Band> bands_;          ///< scratch: of a cell
};

} // namespace orograph
