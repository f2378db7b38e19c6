// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/nested_in_bands.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace orograph {
namespace {

constexpr int kGroup = 64;    // rows: one cell of the coarsest level that there is
constexpr int kStrip = 1024;  // columns: one patch of it, so that no two strips share one
constexpr int kColumns = 256; // at a time: what is known of them stays in the nearest cache

// Some columns of a row of cells of a level, between two rows of the grid, and how far the grid's
// rows are from its triangles: in the order of `certified_patches`, to the bit. All of it are plain
// loops, which the processor does several steps of at a time.
class CellRow {
public:
  template <class Height>
  void lay(const Height* north, const Height* south, int columns, int step) {
    columns_ = static_cast<std::size_t>(columns);
    step_ = static_cast<std::size_t>(step);
    const double share = 1.0 / step;
    for (int first = 0; first < columns; first += step) {
      const double nw = north[first], ne = north[first + step], sw = south[first],
                   se = south[first + step];
      for (int c = 0; c < step; ++c) {
        const auto i = static_cast<std::size_t>(first + c);
        from_[i] = nw + (ne - nw) * (c * share);
        down_[i] = se - ne;
        across_[i] = 0;
        from_below_[i] = nw;
        down_below_[i] = sw - nw;
        across_below_[i] = (se - sw) * (c * share);
      }
    }
  }

  /// The `r`th of the rows from one to the other, `step` and one. REQUIRES that they come in order.
  /// The last is another cell's first, too: what is missing there counts, its squares don't.
  template <class Height>
  void compare(const Height* line, std::size_t r) {
    for (std::size_t i = r; i < columns_ && r < step_; i += step_) { // now below the diagonal
      from_[i] = from_below_[i];
      down_[i] = down_below_[i];
      across_[i] = across_below_[i];
    }
    const double y = static_cast<double>(r) * (1.0 / static_cast<double>(step_)),
                 weight = r < step_ ? 1 : 0;
    for (std::size_t i = 0; i < columns_; ++i) {
      const double apart = std::abs(from_[i] + down_[i] * y + across_[i] - line[i]);
      greatest_[i] = apart > greatest_[i] ? apart : greatest_[i];
      squares_[i] += weight * (apart * apart);
    }
  }

  void begin() {
    greatest_.fill(0);
    squares_.fill(0);
  }
  double greatest_m(int column) const { return greatest_[static_cast<std::size_t>(column)]; }
  double squares(int column) const { return squares_[static_cast<std::size_t>(column)]; }

private:
  std::size_t columns_ = 0, step_ = 1;
  std::array<double, kColumns> from_, down_, across_, from_below_, down_below_, across_below_;
  std::array<double, kColumns> greatest_, squares_;
};

// The last column of a cell that ends a patch.
template <class Height>
double apart_at_end(const Height* north, const Height* south, const Height* line, int column,
                    int step, double y) {
  const double nw = north[column - step], ne = north[column], sw = south[column - step],
               se = south[column];
  const double drawn =
      y < 1 ? nw + (ne - nw) * 1.0 + (se - ne) * y : nw + (sw - nw) * y + (se - sw) * 1.0;
  return std::abs(drawn - line[column]);
}

template <class Height>
NestedHeights no_heights(int columns, int rows) {
  return std::vector<Height>(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
}

} // namespace

template <class Height>
NestedInBands<Height>::NestedInBands(int columns, int rows) {
  cells_.columns = columns;
  cells_.rows = rows;
  cells_.coarsest = coarsest_level(Grid{columns, rows, {}, {}});
  const auto patches = [&](int level) {
    return static_cast<std::size_t>(patches_along(columns, level)) *
           static_cast<std::size_t>(patches_along(rows, level));
  };
  cells_.ranges.resize(patches(0));
  for (int level = 1; level <= cells_.coarsest; ++level) sums_.emplace_back(patches(level));
  for (int level = kFinestKept; level <= cells_.coarsest; ++level)
    cells_.heights.push_back(
        no_heights<Height>(nested_places(columns, level), nested_places(rows, level)));
}

template <class Height>
void NestedInBands<Height>::take(const Band<Height>& band) {
  bands_.push_back(band);
  const int end = band.first_row + band.rows, last = cells_.rows - 1;
  while (taken_ <= last && std::min(taken_ + kGroup, last) < end) {
    take_rows(taken_, std::min(taken_ + kGroup, last));
    taken_ += kGroup;
  }
  while (!bands_.empty() && bands_.front().first_row + bands_.front().rows <= taken_)
    bands_.pop_front();
}

template <class Height>
const Height* NestedInBands<Height>::line(int row) const {
  const auto band = std::ranges::find_if(
      bands_, [&](const Band<Height>& of) { return row < of.first_row + of.rows; });
  return band->heights->data() +
         static_cast<std::size_t>(row - band->first_row) * static_cast<std::size_t>(cells_.columns);
}

// A group of rows, and the first one of the next.
template <class Height>
void NestedInBands<Height>::take_rows(int first_row, int last_row) {
  std::vector<const Height*> lines;
  for (int row = first_row; row <= last_row; ++row) lines.push_back(line(row));
  for (int row = first_row; row <= std::min(last_row, first_row + kGroup - 1); ++row)
    keep_heights(row, lines[static_cast<std::size_t>(row - first_row)]);
  if (last_row == first_row) return;
  on_all_cores(static_cast<std::size_t>((cells_.columns - 2) / kStrip + 1), [&](std::size_t i) {
    const auto strip = static_cast<int>(i);
    find_ranges(first_row, lines, strip);
    for (int level = 1; level <= cells_.coarsest; ++level) compare(level, first_row, lines, strip);
  });
}

template <class Height>
void NestedInBands<Height>::keep_heights(int row, const Height* line) {
  for (int level = kFinestKept; level <= cells_.coarsest && row % (1 << level) == 0; ++level) {
    auto& heights = std::get<std::vector<Height>>(
        cells_.heights[static_cast<std::size_t>(level - kFinestKept)]);
    const int width = nested_places(cells_.columns, level);
    Height* const to = heights.data() + static_cast<std::ptrdiff_t>(row >> level) * width;
    for (int i = 0; i < width; ++i) to[i] = line[static_cast<std::ptrdiff_t>(i) << level];
  }
}

template <class Height>
void NestedInBands<Height>::find_ranges(int first_row, const std::vector<const Height*>& lines,
                                        int strip) {
  constexpr Height kFar = std::numeric_limits<Height>::infinity();
  const int begin = strip * kStrip, end = std::min(begin + kStrip, cells_.columns - 1),
            last_line = static_cast<int>(lines.size()) - 1;
  std::array<Height, kStrip + 1> low, high;
  for (int from = 0; from < last_line; from += kPatchCells) {
    low.fill(kFar);
    high.fill(-kFar);
    for (int row = from; row <= std::min(from + kPatchCells, last_line); ++row) {
      const Height* const line = lines[static_cast<std::size_t>(row)] + begin;
      for (std::size_t i = 0; i <= static_cast<std::size_t>(end - begin); ++i) { // false for NaN
        low[i] = line[i] < low[i] ? line[i] : low[i];
        high[i] = line[i] > high[i] ? line[i] : high[i];
      }
    }
    PartHeights* const ranges =
        cells_.ranges.data() + static_cast<std::ptrdiff_t>((first_row + from) / kPatchCells) *
                                   patches_along(cells_.columns, 0);
    for (int at = begin; at < end; at += kPatchCells) {
      PartHeights& range = ranges[at / kPatchCells];
      for (int i = at - begin; i <= std::min(at + kPatchCells, end) - begin; ++i)
        range.include({low[static_cast<std::size_t>(i)], high[static_cast<std::size_t>(i)]});
    }
  }
}

// Each height of the grid with the cell of which it is the north-west corner or beside that, and
// those on a patch's far borders with its last cells, too.
template <class Height>
void NestedInBands<Height>::compare(int level, int first_row,
                                    const std::vector<const Height*>& lines, int strip) {
  const int step = 1 << level, side = kPatchCells * step;
  const int whole_columns = (cells_.columns - 1) / step * step,
            whole_rows = (cells_.rows - 1) / step * step;
  const int end = std::min((strip + 1) * kStrip, whole_columns),
            end_row = std::min(first_row + kGroup, whole_rows);
  const auto line = [&](int row) { return lines[static_cast<std::size_t>(row - first_row)]; };
  CellRow cells;
  for (int begin = strip * kStrip; begin < end; begin += kColumns) {
    const int columns = std::min(kColumns, end - begin);
    std::vector<int> ends; // of patches
    for (int column = (begin / side + 1) * side; column < begin + columns; column += side)
      ends.push_back(column);
    if (begin + columns == whole_columns || (begin + columns) % side == 0)
      ends.push_back(begin + columns);
    for (int from = first_row; from < end_row; from += std::min(side, kGroup)) {
      Sums* const sums =
          sums_[static_cast<std::size_t>(level - 1)].data() +
          static_cast<std::ptrdiff_t>(from / side) * patches_along(cells_.columns, level);
      cells.begin();
      for (int row = from; row < std::min(from + side, end_row); row += step) {
        const Height *const north = line(row), *const south = line(row + step);
        cells.lay(north + begin, south + begin, columns, step);
        const bool ends_patch = (row + step) % side == 0 || row + step == whole_rows;
        for (int r = 0; r < (ends_patch ? step + 1 : step); ++r) {
          cells.compare(line(row + r) + begin, static_cast<std::size_t>(r));
          for (const int column : ends) {
            const double apart =
                apart_at_end(north, south, line(row + r), column, step, r * (1.0 / step));
            Sums& of = sums[(column - 1) / side];
            of.greatest_m = std::max(of.greatest_m, apart);
            of.squares += 0 * apart; // NaN where it is missing
          }
        }
      }
      for (int i = 0; i < columns; ++i) {
        Sums& of = sums[(begin + i) / side];
        of.greatest_m = std::max(of.greatest_m, cells.greatest_m(i));
        of.squares += cells.squares(i);
      }
    }
  }
}

template <class Height>
NestedCells NestedInBands<Height>::move_cells() {
  constexpr Departure kNotWhole{std::numeric_limits<double>::infinity(), 0};
  for (int level = 1; level <= cells_.coarsest; ++level) {
    const std::vector<Sums>& sums = sums_[static_cast<std::size_t>(level - 1)];
    const int across = patches_along(cells_.columns, level), side = kPatchCells << level;
    std::vector<Departure>& out = cells_.departures.emplace_back();
    out.reserve(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const auto number = static_cast<int>(i);
      const int wide = std::min(side, cells_.columns - 1 - number % across * side),
                high = std::min(side, cells_.rows - 1 - number / across * side);
      const bool is_whole = wide % (1 << level) == 0 && high % (1 << level) == 0;
      out.push_back(is_whole && !std::isnan(sums[i].squares)
                        ? Departure{sums[i].greatest_m, std::sqrt(sums[i].squares / wide / high)}
                        : kNotWhole);
    }
  }
  return std::move(cells_);
}

template class NestedInBands<float>;
template class NestedInBands<double>;

} // namespace orograph
