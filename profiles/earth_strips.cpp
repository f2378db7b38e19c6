// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/earth_strips.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {

EarthStrips::EarthStrips(const Grid& grid, const View& view, const LookedAt& looked, bool are_rows)
    : grid_(&grid), view_(view), looked_(looked), are_rows_(are_rows),
      lines_(are_rows ? grid.rows : grid.columns), vertices_(are_rows ? grid.columns : grid.rows),
      blocks_((vertices_ + kBlock - 1) / kBlock),
      cells_in_row_(static_cast<std::uint32_t>(grid.columns) - 1),
      line_(static_cast<std::size_t>(lines_)), looked_at_(static_cast<std::size_t>(lines_) - 1),
      depths_(looked_at_.size(), Depths{kInfinity, -kInfinity}),
      block_(static_cast<std::size_t>(lines_) * static_cast<std::size_t>(blocks_)) {}

bool EarthStrips::falls(int strip, int cell) const {
  if (cell > 0 && cell < cells()) return falling_.falls(strip, cell);
  // At the strip's end, where rounding doesn't matter.
  const double left = way_to_left(view_, vertex(strip, cell), vertex(strip + 1, cell));
  return lower_is_right_ == are_rows_ ? left > 0 : left < 0;
}

bool EarthStrips::is_lower_near(int column, int row) const {
  const int line = are_rows_ ? row : column, at = are_rows_ ? column : row;
  return is_lower_near(vertex(line, at), vertex(line + 1, at + 1));
}

ProfilePoint EarthStrips::vertex(int line, int at) const {
  return to_profile_frame(view_, are_rows_ ? grid_->vertex_m(at, line) : grid_->vertex_m(line, at));
}

ProfilePoint EarthStrips::filled_vertex(int line, int at) const {
  const EarthLattice& earth = grid_->earth();
  const auto height = [&](int i) {
    const int column = are_rows_ ? i : line, row = are_rows_ ? line : i;
    return earth.leaning_height_m(column, row, grid_->height_m(column, row));
  };
  double height_m = height(at);
  for (int i = at - 1; i >= 0 && std::isnan(height_m); --i) height_m = height(i);
  for (int i = at + 1; i < vertices_ && std::isnan(height_m); ++i) height_m = height(i);
  if (std::isnan(height_m)) height_m = 0;
  return to_profile_frame(view_, are_rows_ ? earth.vertex_m(at, line, height_m)
                                           : earth.vertex_m(line, at, height_m));
}

template <class Before>
std::pair<int, int> EarthStrips::parting(int line, double sought, const Before& before) const {
  const Line& of = line_[static_cast<std::size_t>(line)];
  const Block* const blocks =
      &block_[static_cast<std::size_t>(line) * static_cast<std::size_t>(blocks_)];
  // `low` is before, `high` isn't.
  int low = of.first_ahead - 1, high = of.last_ahead + 1;
  int first = (of.first_ahead + kBlock - 1) / kBlock, end = of.last_ahead / kBlock + 1;
  while (first < end) {
    const int middle = first + (end - first) / 2;
    if (before(blocks[middle].x)) {
      low = middle * kBlock;
      first = middle + 1;
    } else {
      high = middle * kBlock;
      end = middle;
    }
  }
  // X is about even within a block: vertices beside the place that its ends tell decide mostly.
  const auto look_at = [&](int at) {
    if (at <= low || at >= high) return;
    if (const ProfilePoint p = vertex(line, at); !std::isnan(p.z))
      (before(x_of(p)) ? low : high) = at;
  };
  constexpr int kFew = 2;
  if (low % kBlock == 0 && high == low + kBlock) {
    const double from = blocks[low / kBlock].x, to = blocks[low / kBlock + 1].x,
                 share = (sought - from) / (to - from);
    if (share >= 0 && share <= 1) {
      const int about = low + static_cast<int>(share * kBlock);
      look_at(about - kFew);
      look_at(about + 1 + kFew);
    }
  }
  while (low + 4 * kFew < high) {
    const int middle = low + (high - low) / 2, width = high - low;
    look_at(middle);
    if (high - low == width) break; // it is missing
  }
  return {low, high};
}

// Cells along the line.
EarthStrips::Cells EarthStrips::shown_of_line(int line, XRange range) const {
  const Line& of = line_[static_cast<std::size_t>(line)];
  const auto [low, first] = parting(line, of.rises ? range.begin : range.end, [&](double x) {
    return of.rises ? x < range.begin : x > range.end;
  });
  const auto [last, high] = parting(line, of.rises ? range.end : range.begin, [&](double x) {
    return of.rises ? x <= range.end : x >= range.begin;
  });
  // To rounding it may be in the next; and what is behind has no X.
  const int begin = low - 1, end = high + 1;
  return {begin < of.first_ahead ? of.first : begin, end > of.last_ahead ? of.last : end};
}

EarthStrips::Shown EarthStrips::shown(int line, int other, XRange range) const {
  const auto is_ahead = [&](int i) {
    const Line& of = line_[static_cast<std::size_t>(i)];
    return of.first_ahead <= of.last_ahead;
  };
  Shown out{{}, kInfinity, -kInfinity};
  const int strip = std::min(line, other);
  if (line == other) {
    if (is_ahead(line)) out.cells = shown_of_line(line, range);
  } else {
    const Cells all = looked_at_[static_cast<std::size_t>(strip)];
    out.cells = all;
    if (strip != own_ && is_ahead(line) && is_ahead(other) && !all.empty()) {
      const Cells a = shown_of_line(line, range), b = shown_of_line(other, range);
      out.cells = {std::max(all.first, std::min(a.first, b.first)),
                   std::min(all.end, std::max(a.end, b.end))};
    }
  }
  if (out.cells.empty()) return {{}, 0, 0};
  const Depths a = depths_of(line, out.cells), b = depths_of(other, out.cells);
  out.nearest_m = std::min(a.nearest_m, b.nearest_m);
  out.farthest_m = std::max(a.farthest_m, b.farthest_m);
  return out;
}

EarthStrips::Depths EarthStrips::depths_of(int line, Cells cells) const {
  Depths out{kInfinity, -kInfinity};
  const Block* const blocks =
      &block_[static_cast<std::size_t>(line) * static_cast<std::size_t>(blocks_)];
  for (int i = cells.first / kBlock; i <= cells.end / kBlock; ++i) {
    out.nearest_m = std::min(out.nearest_m, static_cast<double>(blocks[i].nearest_m));
    out.farthest_m = std::max(out.farthest_m, static_cast<double>(blocks[i].farthest_m));
  }
  return out;
}

} // namespace orograph
