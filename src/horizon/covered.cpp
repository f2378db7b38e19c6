// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/covered.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Of exact comparison; a source against itself is tied.
constexpr TieTolerance kExactly{};

struct Extent {
  double low, high;
};
Extent extent_of(const Segment& s, double begin, double end) {
  const double a = height_at(s, begin), b = height_at(s, end);
  return {std::min(a, b), std::max(a, b)};
}

// What rounding may add to heights like these.
double rounding_of(Extent extent) {
  return 1e-12 * (std::abs(extent.low) + std::abs(extent.high));
}

// The side of p against s at an X beside any crossing: above 0, below 0, or 0 where they are one.
int side_at(const Standing& standing, double x) {
  using enum Standing::Kind;
  switch (standing.kind) {
  case above:
    return 1;
  case below:
    return -1;
  case tied:
    return 0;
  case above_then_below:
    return x < standing.x ? 1 : -1;
  case below_then_above:
    return x < standing.x ? -1 : 1;
  }
  return 0;
}

Standing exact_standing(const Segment& p, const Segment& s) {
  return p.id == s.id ? Standing{Standing::Kind::tied} : compare(p, s, kExactly);
}

bool is_same(const Band& a, const Band& b) {
  return a.bottom.id == b.bottom.id && a.top.id == b.top.id;
}

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

Covered::Covered(XRange core, XRange range, std::size_t count)
    : x_begin_(core.begin), columns_per_x_(static_cast<double>(count) / (core.end - core.begin)) {
  const double width = (core.end - core.begin) / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    Column column;
    column.x_begin = i == 0 ? range.begin : columns_.back().x_end;
    column.x_end = i + 1 == count ? range.end : core.begin + static_cast<double>(i + 1) * width;
    column.cells.push_back(
        {column.x_begin, column.x_end, 0, 0, 0, kInfinity, -kInfinity, kInfinity, -kInfinity});
    column.find_bounds();
    columns_.push_back(std::move(column));
  }
}

std::size_t Covered::column_at(double x) const {
  const double last = static_cast<double>(columns_.size() - 1);
  auto at = static_cast<std::size_t>(std::clamp((x - x_begin_) * columns_per_x_, 0.0, last));
  while (at > 0 && x < columns_[at].x_begin) --at;
  while (at + 1 < columns_.size() && x >= columns_[at].x_end) ++at;
  return at;
}

void Covered::Column::find_bounds() {
  is_one_band = true;
  low = inner_high = kInfinity;
  high = inner_low = -kInfinity;
  for (const CoveredCell& cell : cells) {
    is_one_band = is_one_band && cell.count == 1;
    low = std::min(low, cell.low);
    high = std::max(high, cell.high);
    inner_low = std::max(inner_low, cell.inner_low);
    inner_high = std::min(inner_high, cell.inner_high);
  }
}

// Neighbours with the same bands are one cell.
void Covered::add_cell(const CoveredCell& cell, std::span<const Band> bands) {
  if (!next_.cells.empty()) {
    CoveredCell& last = next_.cells.back();
    if (last.count == bands.size() && (last.open == cell.open || last.count <= 1) &&
        std::equal(bands.begin(), bands.end(), next_.bands.begin() + last.first, is_same)) {
      last.x_end = cell.x_end;
      last.low = std::min(last.low, cell.low);
      last.high = std::max(last.high, cell.high);
      last.inner_low = std::max(last.inner_low, cell.inner_low);
      last.inner_high = std::min(last.inner_high, cell.inner_high);
      return;
    }
  }
  next_.cells.push_back(cell);
  next_.cells.back().first = static_cast<std::uint32_t>(next_.bands.size());
  next_.bands.insert(next_.bands.end(), bands.begin(), bands.end());
}

void Covered::add_cell(double begin, double end, std::span<const Band> bands, std::uint32_t open) {
  CoveredCell cell{begin,     end,       0,          static_cast<std::uint32_t>(bands.size()),
                   open,      kInfinity, -kInfinity, kInfinity,
                   -kInfinity};
  if (!bands.empty()) {
    const auto padded = [&](const Segment& s) {
      const Extent extent = extent_of(s, begin, end);
      return Extent{extent.low - rounding_of(extent), extent.high + rounding_of(extent)};
    };
    cell.low = padded(bands.front().bottom).low;
    cell.high = padded(bands.back().top).high;
    cell.inner_low = padded(bands[open].bottom).high;
    cell.inner_high = padded(bands[open].top).low;
  }
  add_cell(cell, bands);
}

void Covered::take(const Segment& source, double x_begin, double x_end, SheetEnd end, bool inked) {
  for (std::size_t i = column_at(x_begin); i < columns_.size() && columns_[i].x_begin < x_end;
       ++i) {
    Column& column = columns_[i];
    const double from = std::max(x_begin, column.x_begin), to = std::min(x_end, column.x_end);
    if (!(from < to)) continue;
    if (column.is_one_band) { // in which the sheet goes on, wherever it is
      const Extent extent = extent_of(source, from, to);
      if (extent.low >= column.inner_low && extent.high <= column.inner_high) continue;
    }
    take_in(column, source, from, to, end, inked);
  }
}

void Covered::take_in(Column& column, const Segment& source, double begin, double end,
                      SheetEnd sheet_end, bool inked) {
  // In the open band the sheet goes on, wherever it is; one that begins has to be told where.
  const auto stays = [&](const CoveredCell& cell) {
    const double from = std::max(begin, cell.x_begin), to = std::min(end, cell.x_end);
    if (!(from < to)) return true;
    if (sheet_end == SheetEnd::opens && cell.count != 1) return false;
    const Extent extent = extent_of(source, from, to);
    return extent.low >= cell.inner_low && extent.high <= cell.inner_high;
  };
  if (std::ranges::all_of(column.cells, stays)) return;
  next_.cells.clear();
  next_.bands.clear();
  for (const CoveredCell& cell : column.cells) {
    const std::span<const Band> bands(column.bands.data() + cell.first, cell.count);
    if (stays(cell)) {
      add_cell(cell, bands);
      continue;
    }
    const auto add_part = [&](double from, double to) {
      CoveredCell part = cell;
      part.x_begin = from;
      part.x_end = to;
      if (from < to) add_cell(part, bands);
    };
    const double from = std::max(begin, cell.x_begin), to = std::min(end, cell.x_end);
    add_part(cell.x_begin, from);
    take_in(column, cell, source, from, to, sheet_end, inked);
    add_part(to, cell.x_end);
  }
  std::swap(column.cells, next_.cells);
  std::swap(column.bands, next_.bands);
  column.find_bounds();
}

void Covered::take_in(const Column& column, const CoveredCell& cell, const Segment& source,
                      double begin, double end, SheetEnd sheet_end, bool inked) {
  const std::span<const Band> bands(column.bands.data() + cell.first, cell.count);
  breaks_.assign({begin, end});
  thread_local std::vector<std::array<Standing, 2>> standings;
  standings.clear();
  for (const Band& band : bands) {
    const auto& both = standings.emplace_back(
        std::array{exact_standing(source, band.bottom), exact_standing(source, band.top)});
    for (const Standing& standing : both)
      if ((standing.kind == Standing::Kind::above_then_below ||
           standing.kind == Standing::Kind::below_then_above) &&
          standing.x > begin && standing.x < end)
        breaks_.push_back(standing.x);
  }
  std::sort(breaks_.begin(), breaks_.end());
  for (std::size_t k = 0; k + 1 < breaks_.size(); ++k) {
    const double from = breaks_[k], to = breaks_[k + 1];
    if (!(from < to)) continue;
    const double x = 0.5 * (from + to);
    std::uint32_t below = 0; // bands
    while (below < cell.count && side_at(standings[below][1], x) > 0) ++below;
    const bool inside = below < cell.count && side_at(standings[below][0], x) >= 0;
    bands_.assign(bands.begin(), bands.end());
    std::uint32_t open = below;
    if (sheet_end == SheetEnd::opens || cell.count == 0) {
      if (!inside) bands_.insert(bands_.begin() + below, Band{source, source, inked, inked});
    } else { // from where the sheet was to here
      const std::uint32_t was = std::min(cell.open, cell.count - 1);
      const std::uint32_t first = std::min(was, below),
                          last = inside ? std::max(was, below)
                                        : std::max(was, below == 0 ? 0 : below - 1);
      const bool is_below_all = !inside && below <= was, is_above_all = !inside && below > was;
      Band joined = bands[first];
      joined.top = bands[last].top;
      joined.top_inked = bands[last].top_inked;
      if (is_below_all) {
        joined.bottom = source;
        joined.bottom_inked = inked;
      }
      if (is_above_all) {
        joined.top = source;
        joined.top_inked = inked;
      }
      bands_.erase(bands_.begin() + first, bands_.begin() + last + 1);
      bands_.insert(bands_.begin() + first, joined);
      open = first;
    }
    add_cell(from, to, bands_, open);
  }
}

void Covered::add_seen(const Segment& line, double x_begin, double x_end,
                       const TieTolerance& tolerance, std::vector<Shares>& seen) const {
  thread_local std::vector<Shares> hidden;
  for (std::size_t i = column_at(x_begin); i < columns_.size() && columns_[i].x_begin < x_end;
       ++i) {
    const Column& column = columns_[i];
    const double from = std::max(x_begin, column.x_begin), to = std::min(x_end, column.x_end);
    if (!(from < to)) continue;
    const Extent extent = extent_of(line, from, to);
    const double slack = tolerance.greatest_y + rounding_of(extent);
    if (column.is_one_band && extent.low > column.inner_low + slack &&
        extent.high < column.inner_high - slack)
      continue;
    if (extent.low > column.high + slack || extent.high < column.low - slack) {
      append(seen, {parameter_at(line, from), parameter_at(line, to)});
      continue;
    }
    for (const CoveredCell& cell : column.cells) {
      const double begin = std::max(from, cell.x_begin), end = std::min(to, cell.x_end);
      if (!(begin < end)) continue;
      const Extent here = extent_of(line, begin, end);
      if (here.low > cell.inner_low + slack && here.high < cell.inner_high - slack) continue;
      const Shares all{parameter_at(line, begin), parameter_at(line, end)};
      if (here.low > cell.high + slack || here.high < cell.low - slack) {
        append(seen, all);
        continue;
      }
      hidden.clear();
      for (std::uint32_t k = cell.first; k < cell.first + cell.count; ++k) {
        const Band& band = column.bands[k];
        const Standing on_bottom = compare(line, band.bottom, tolerance),
                       on_top = compare(line, band.top, tolerance);
        const bool is_tied =
            on_bottom.kind == Standing::Kind::tied || on_top.kind == Standing::Kind::tied;
        if (is_tied) {
          if ((on_bottom.kind == Standing::Kind::tied && band.bottom_inked) ||
              (on_top.kind == Standing::Kind::tied && band.top_inked))
            hidden.push_back(all);
          continue;
        }
        const Shares above = shares_on_side(on_bottom, true, all),
                     below = shares_on_side(on_top, false, all);
        const Shares both{std::max(above.begin, below.begin), std::min(above.end, below.end)};
        if (both.begin < both.end) hidden.push_back(both);
      }
      append_without(seen, all, hidden);
    }
  }
}

void Covered::add_upright_seen(const Segment& upright, bool left, std::vector<Shares>& seen) const {
  const double x = upright.x0, y0 = upright.y0, y1 = upright.y1;
  if (y0 == y1) return;
  std::size_t at = column_at(x);
  if (left && at > 0 && columns_[at].x_begin >= x) --at;
  const Column& column = columns_[at];
  auto cell = std::ranges::find_if(
      column.cells, [&](const CoveredCell& of) { return left ? x <= of.x_end : x < of.x_end; });
  if (cell == column.cells.end()) --cell;
  const auto share = [&](double y) { return std::clamp((y - y0) / (y1 - y0), 0.0, 1.0); };
  thread_local std::vector<Shares> hidden;
  hidden.clear();
  for (std::uint32_t k = cell->first; k < cell->first + cell->count; ++k) {
    const Band& band = column.bands[k];
    const double bottom =
                     share(height_at(band.bottom, std::clamp(x, band.bottom.x0, band.bottom.x1))),
                 top = share(height_at(band.top, std::clamp(x, band.top.x0, band.top.x1)));
    hidden.push_back({std::min(bottom, top), std::max(bottom, top)});
  }
  append_without(seen, {0, 1}, hidden);
}

Horizon Covered::top() const {
  Horizon out;
  const HorizonPiece sky = initial_horizon().front();
  for (const Column& column : columns_)
    for (const CoveredCell& cell : column.cells) {
      HorizonPiece piece = sky;
      if (cell.count > 0) {
        const Band& band = column.bands[cell.first + cell.count - 1];
        piece.source = band.top;
        piece.inked = band.top_inked;
      }
      piece.x_begin = cell.x_begin;
      piece.x_end = cell.x_end;
      append(out, piece, true);
    }
  return out;
}

} // namespace orograph
