// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/covered.hpp"

#include "geometry/large_pages.hpp"
#include "horizon/extent_of_heights.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace orograph {
namespace {

// Of exact comparison; a source against itself is tied.
constexpr TieTolerance kExactly{};

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

} // namespace

Covered::Covered(XRange core, XRange range, std::size_t count)
    : x_begin_(core.begin), columns_per_x_(static_cast<double>(count) / (core.end - core.begin)) {
  const double width = (core.end - core.begin) / static_cast<double>(count);
  columns_.reserve(count);
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

void Covered::expect(std::size_t sources) {
  sources_.reserve(sources);
  use_large_pages(sources_.data(), sources * sizeof(Source));
}

std::size_t Covered::column_at(double x) const {
  const double last = static_cast<double>(columns_.size() - 1);
  auto at = static_cast<std::size_t>(std::clamp((x - x_begin_) * columns_per_x_, 0.0, last));
  while (at > 0 && x < columns_[at].x_begin) --at;
  while (at + 1 < columns_.size() && x >= columns_[at].x_end) ++at;
  return at;
}

std::size_t Covered::Column::cell_at(double x) const {
  return static_cast<std::size_t>(
      std::partition_point(cells.begin(), cells.end(),
                           [&](const CoveredCell& cell) { return cell.x_end <= x; }) -
      cells.begin());
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

bool Covered::have_same_bands(const Column& column, const CoveredCell& a,
                              const CoveredCell& b) const {
  if (a.count != b.count || (a.open != b.open && a.count > 1)) return false;
  const auto is_one = [&](std::uint32_t i, std::uint32_t j) {
    return i == j || sources_[i].line.id == sources_[j].line.id;
  };
  return a.first == b.first ||
         std::ranges::equal(column.bands_of(a), column.bands_of(b), [&](Band left, Band right) {
           return is_one(left.bottom, right.bottom) && is_one(left.top, right.top);
         });
}

// Neighbours with the same bands are one cell.
void Covered::add_cell(const Column& column, const CoveredCell& cell) {
  if (changed_.empty() || !have_same_bands(column, changed_.back(), cell)) {
    changed_.push_back(cell);
    return;
  }
  CoveredCell& last = changed_.back();
  last.x_end = cell.x_end;
  last.low = std::min(last.low, cell.low);
  last.high = std::max(last.high, cell.high);
  last.inner_low = std::max(last.inner_low, cell.inner_low);
  last.inner_high = std::min(last.inner_high, cell.inner_high);
}

// Of what is in `bands_`.
void Covered::add_changed(Column& column, double begin, double end, std::uint32_t open) {
  CoveredCell cell{begin,      end,       static_cast<std::uint32_t>(column.bands.size()),
                   0,          open,      kInfinity,
                   -kInfinity, kInfinity, -kInfinity};
  cell.count = static_cast<std::uint32_t>(bands_.size());
  if (!bands_.empty()) {
    const auto padded = [&](std::uint32_t number) {
      const Extent extent = extent_of(sources_[number].line, begin, end);
      return Extent{extent.low - rounding_of(extent), extent.high + rounding_of(extent)};
    };
    const Extent bottom = padded(bands_[open].bottom), top = padded(bands_[open].top);
    cell.low = open == 0 ? bottom.low : padded(bands_.front().bottom).low;
    cell.high = open + 1 == cell.count ? top.high : padded(bands_.back().top).high;
    cell.inner_low = bottom.high;
    cell.inner_high = top.low;
  }
  column.bands.insert(column.bands.end(), bands_.begin(), bands_.end());
  const std::size_t cells = changed_.size();
  add_cell(column, cell);
  if (changed_.size() == cells) column.bands.resize(cell.first);
}

std::uint32_t Covered::number_of(const Segment& source, bool inked) {
  if (sources_.empty() || sources_.back().line.id != source.id ||
      sources_.back().line.x0 != source.x0)
    sources_.push_back({source, inked});
  return static_cast<std::uint32_t>(sources_.size()) - 1;
}

void Covered::take(const Segment& source, double x_begin, double x_end, SheetEnd end, bool inked) {
  for (std::size_t i = column_at(x_begin); i < columns_.size() && columns_[i].x_begin < x_end;
       ++i) {
    Column& column = columns_[i];
    const double from = std::max(x_begin, column.x_begin), to = std::min(x_end, column.x_end);
    if (!(from < to)) continue;
    // In the open band the sheet goes on, wherever it is; one that begins has to be told where.
    if (column.is_one_band || end != SheetEnd::opens) {
      const Extent extent = extent_of(source, from, to);
      if (extent.low >= column.inner_low && extent.high <= column.inner_high) continue;
    }
    take_in(column, source, from, to, end, inked);
  }
}

void Covered::take_in(Column& column, const Segment& source, double begin, double end,
                      SheetEnd sheet_end, bool inked) {
  std::vector<CoveredCell>& cells = column.cells;
  const auto stays = [&](const CoveredCell& cell) {
    if (sheet_end == SheetEnd::opens && cell.count != 1) return false;
    const Extent extent =
        extent_of(source, std::max(begin, cell.x_begin), std::min(end, cell.x_end));
    return extent.low >= cell.inner_low && extent.high <= cell.inner_high;
  };
  std::size_t first = column.cell_at(begin);
  while (first < cells.size() && cells[first].x_begin < end && stays(cells[first])) ++first;
  if (first == cells.size() || !(cells[first].x_begin < end)) return;
  const std::uint32_t number = number_of(source, inked);
  changed_.clear();
  std::size_t last = first;
  if (first > 0) changed_.push_back(cells[--first]); // which may become one with what is made
  for (; last < cells.size() && cells[last].x_begin < end; ++last) {
    const CoveredCell cell = cells[last];
    if (stays(cell)) {
      add_cell(column, cell);
      continue;
    }
    const auto add_part = [&](double from, double to) {
      CoveredCell part = cell;
      part.x_begin = from;
      part.x_end = to;
      if (from < to) add_cell(column, part);
    };
    const double from = std::max(begin, cell.x_begin), to = std::min(end, cell.x_end);
    add_part(cell.x_begin, from);
    take_in(column, cell, number, from, to, sheet_end);
    add_part(to, cell.x_end);
  }
  if (last < cells.size()) add_cell(column, cells[last++]);
  const auto at = cells.begin() + static_cast<std::ptrdiff_t>(first);
  const std::size_t both = std::min(last - first, changed_.size());
  const auto rest = changed_.begin() + static_cast<std::ptrdiff_t>(both);
  const auto behind = std::copy(changed_.begin(), rest, at);
  if (both < changed_.size())
    cells.insert(behind, rest, changed_.end());
  else
    cells.erase(behind, cells.begin() + static_cast<std::ptrdiff_t>(last));
  column.find_bounds();
  leave_out_unused(column);
}

void Covered::leave_out_unused(Column& column) {
  std::size_t used = 0;
  for (const CoveredCell& cell : column.cells) used += cell.count;
  constexpr std::size_t kFew = 64;
  if (column.bands.size() <= kFew + 4 * used) return;
  std::vector<Band> bands;
  bands.reserve(2 * used);
  for (CoveredCell& cell : column.cells) {
    const std::span<const Band> of_cell = column.bands_of(cell);
    cell.first = static_cast<std::uint32_t>(bands.size());
    bands.insert(bands.end(), of_cell.begin(), of_cell.end());
  }
  column.bands = std::move(bands);
}

void Covered::take_in(Column& column, const CoveredCell& cell, std::uint32_t number, double begin,
                      double end, SheetEnd sheet_end) {
  const Segment source = sources_[number].line;
  const double apart = 2 * rounding_of(extent_of(source, begin, end));
  breaks_.assign({begin, end});
  const auto standing = [&](std::uint32_t of) -> Standing {
    const Segment& s = sources_[of].line;
    if (source.id == s.id) return {Standing::Kind::tied};
    const HeightAbove height = height_above(source, s, begin, end);
    if (height.is_more_than(apart)) return {Standing::Kind::above};
    if (height.is_less_than(-apart)) return {Standing::Kind::below};
    const Standing out = compare(source, s, kExactly);
    if ((out.kind == Standing::Kind::above_then_below ||
         out.kind == Standing::Kind::below_then_above) &&
        out.x > begin && out.x < end)
      breaks_.push_back(out.x);
    return out;
  };
  // Bands below the source, then those that have to be asked closely.
  thread_local std::vector<std::array<Standing, 2>> standings;
  standings.clear();
  // From where the sheet was: most often it is near there still.
  const auto is_above = [&](std::uint32_t band) {
    const Segment& top = sources_[column.bands[cell.first + band].top].line;
    return source.id != top.id && height_above(source, top, begin, end).is_more_than(apart);
  };
  std::uint32_t first = std::min(cell.open, cell.count);
  while (first < cell.count && is_above(first)) ++first;
  while (first > 0 && !is_above(first - 1)) --first;
  for (std::uint32_t i = first; i < cell.count; ++i) {
    const Band band = column.bands[cell.first + i];
    const Standing to_bottom = standing(band.bottom);
    if (to_bottom.kind == Standing::Kind::below) break; // and below its top, and the next
    standings.push_back({to_bottom, standing(band.top)});
  }
  const std::uint32_t beyond = first + static_cast<std::uint32_t>(standings.size());
  std::sort(breaks_.begin(), breaks_.end());
  for (std::size_t k = 0; k + 1 < breaks_.size(); ++k) {
    const double from = breaks_[k], to = breaks_[k + 1];
    if (!(from < to)) continue;
    const double x = 0.5 * (from + to);
    std::uint32_t below = first; // bands
    while (below < beyond && side_at(standings[below - first][1], x) > 0) ++below;
    const bool inside = below < beyond && side_at(standings[below - first][0], x) >= 0;
    const std::span<const Band> bands = column.bands_of(cell);
    bands_.assign(bands.begin(), bands.end());
    std::uint32_t open = below;
    if (sheet_end == SheetEnd::opens || cell.count == 0) {
      if (!inside) bands_.insert(bands_.begin() + below, Band{number, number});
    } else { // from where the sheet was to here
      const std::uint32_t was = std::min(cell.open, cell.count - 1);
      const std::uint32_t from_band = std::min(was, below),
                          to_band = inside ? std::max(was, below)
                                           : std::max(was, below == 0 ? 0 : below - 1);
      const bool is_below_all = !inside && below <= was, is_above_all = !inside && below > was;
      Band joined{bands[from_band].bottom, bands[to_band].top};
      if (is_below_all) joined.bottom = number;
      if (is_above_all) joined.top = number;
      bands_.erase(bands_.begin() + from_band, bands_.begin() + to_band + 1);
      bands_.insert(bands_.begin() + from_band, joined);
      open = from_band;
    }
    add_changed(column, from, to, open);
  }
}

Horizon Covered::top() const {
  Horizon out;
  const HorizonPiece sky = initial_horizon().front();
  for (const Column& column : columns_)
    for (const CoveredCell& cell : column.cells) {
      HorizonPiece piece = sky;
      if (cell.count > 0) {
        const Source& top = sources_[column.bands_of(cell).back().top];
        piece.source = top.line;
        piece.inked = top.inked;
      }
      piece.x_begin = cell.x_begin;
      piece.x_end = cell.x_end;
      append(out, piece, true);
    }
  return out;
}

} // namespace orograph
