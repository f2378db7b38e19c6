// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/covered.hpp"
#include "horizon/extent_of_heights.hpp"

#include <algorithm>

namespace orograph {
namespace {

// What of a line is above a source, or below it, as shares; of a tie nothing.
Shares shares_on_side(const Standing& standing, bool upper, Shares all) {
  using enum Standing::Kind;
  const double t = std::clamp(standing.t, all.begin, all.end);
  switch (standing.kind) {
  case above:
    return upper ? all : Shares{all.begin, all.begin};
  case below:
    return upper ? Shares{all.begin, all.begin} : all;
  case tied:
    return {all.begin, all.begin};
  case above_then_below:
    return upper ? Shares{all.begin, t} : Shares{t, all.end};
  case below_then_above:
    return upper ? Shares{t, all.end} : Shares{all.begin, t};
  }
  return all;
}

void append(std::vector<Shares>& seen, Shares part) {
  if (!(part.begin < part.end)) return;
  if (!seen.empty() && seen.back().end == part.begin)
    seen.back().end = part.end;
  else
    seen.push_back(part);
}

// Takes what is hidden, bottom to top or left to right, out of what may be seen.
void append_without(std::vector<Shares>& seen, Shares all, std::vector<Shares>& hidden) {
  std::sort(hidden.begin(), hidden.end(),
            [](const Shares& a, const Shares& b) { return a.begin < b.begin; });
  double begin = all.begin;
  for (const Shares& part : hidden) {
    append(seen, {begin, std::min(part.begin, all.end)});
    begin = std::max(begin, part.end);
  }
  append(seen, {begin, all.end});
}

} // namespace

bool Covered::add_seen(const Segment& line, double x_begin, double x_end,
                       const TieTolerance& tolerance, std::vector<Shares>& seen) const {
  bool is_inside = true;
  for (std::size_t i = column_at(x_begin); i < columns_.size() && columns_[i].x_begin < x_end;
       ++i) {
    const Column& column = columns_[i];
    const double from = std::max(x_begin, column.x_begin), to = std::min(x_end, column.x_end);
    if (!(from < to)) continue;
    const Extent extent = extent_of(line, from, to);
    const double slack = tolerance.greatest_y + rounding_of(extent);
    if (extent.low > column.inner_low + slack && extent.high < column.inner_high - slack) continue;
    if (extent.low > column.high + slack || extent.high < column.low - slack) {
      append(seen, {parameter_at(line, from), parameter_at(line, to)});
      is_inside = false;
      continue;
    }
    double begin = from, y_begin = height_at(line, from);
    for (std::size_t k = column.cell_at(from); begin < to; ++k) {
      const CoveredCell& cell = column.cells[k];
      const double end = std::min(to, cell.x_end), y_end = height_at(line, end);
      const double low = std::min(y_begin, y_end), high = std::max(y_begin, y_end);
      if (!(low > cell.inner_low + slack && high < cell.inner_high - slack)) {
        const Shares all{parameter_at(line, begin), parameter_at(line, end)};
        if (low > cell.high + slack || high < cell.low - slack) {
          append(seen, all);
          is_inside = false;
        } else if (!add_seen_in(column.bands_of(cell), cell.open, line, begin, end, all, tolerance,
                                seen)) {
          is_inside = false;
        }
      }
      begin = end;
      y_begin = y_end;
    }
  }
  return is_inside;
}

// Of what is in one cell.
bool Covered::add_seen_in(std::span<const Band> bands, std::uint32_t open, const Segment& line,
                          double begin, double end, Shares all, const TieTolerance& tolerance,
                          std::vector<Shares>& seen) const {
  // More than rounding and the tolerance make of it.
  const double apart = tolerance.greatest_y + 2 * rounding_of(extent_of(line, begin, end));
  thread_local std::vector<Shares> hidden;
  hidden.clear();
  for (const Band& band : bands) {
    const auto& [top, top_inked] = sources_[band.top];
    const HeightAbove above_top = height_above(line, top, begin, end);
    if (above_top.is_more_than(apart)) continue;
    const auto& [bottom, bottom_inked] = sources_[band.bottom];
    const HeightAbove above_bottom = height_above(line, bottom, begin, end);
    if (above_bottom.is_less_than(-apart)) break; // and below all others
    if (above_bottom.is_more_than(apart) && above_top.is_less_than(-apart))
      return &band - bands.data() == static_cast<std::ptrdiff_t>(open);
    const Standing on_bottom = compare(line, bottom, tolerance),
                   on_top = compare(line, top, tolerance);
    const bool is_tied =
        on_bottom.kind == Standing::Kind::tied || on_top.kind == Standing::Kind::tied;
    if (is_tied) {
      if ((on_bottom.kind == Standing::Kind::tied && bottom_inked) ||
          (on_top.kind == Standing::Kind::tied && top_inked))
        hidden.push_back(all);
      continue;
    }
    const Shares above = shares_on_side(on_bottom, true, all),
                 below = shares_on_side(on_top, false, all);
    const Shares both{std::max(above.begin, below.begin), std::min(above.end, below.end)};
    if (both.begin < both.end) hidden.push_back(both);
  }
  append_without(seen, all, hidden);
  return false;
}

void Covered::add_upright_seen(const Segment& upright, double beside,
                               std::vector<Shares>& seen) const {
  const double x = upright.x0, y0 = upright.y0, y1 = upright.y1;
  if (y0 == y1) return;
  const Column& column = columns_[column_at(beside)];
  const std::size_t at = std::min(column.cell_at(beside), column.cells.size() - 1);
  const CoveredCell& cell = column.cells[at];
  const auto share = [&](std::uint32_t number) {
    const Segment& s = sources_[number].line;
    return std::clamp((height_at(s, std::clamp(x, s.x0, s.x1)) - y0) / (y1 - y0), 0.0, 1.0);
  };
  thread_local std::vector<Shares> hidden;
  hidden.clear();
  for (const Band& band : column.bands_of(cell)) {
    const auto [low, high] = std::minmax({share(band.bottom), share(band.top)});
    hidden.push_back({low, high});
  }
  append_without(seen, {0, 1}, hidden);
}

} // namespace orograph
