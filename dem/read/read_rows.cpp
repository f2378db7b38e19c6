// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/read_rows.hpp"

#include "geometry/large_pages.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <variant>

namespace orograph {
namespace {

template <class Value>
std::vector<Value> no_heights(std::size_t count) {
  std::vector<Value> heights;
  fill_on_large_pages(heights, count, std::numeric_limits<Value>::quiet_NaN());
  return heights;
}

RasterWindow common(const RasterWindow& a, const RasterWindow& b) {
  const int pixel = std::max(a.pixel, b.pixel), line = std::max(a.line, b.line);
  return {pixel, line, std::min(a.pixel + a.pixels, b.pixel + b.pixels) - pixel,
          std::min(a.line + a.lines, b.line + b.lines) - line};
}

// `differences` where places may have a height already: files overlap, or blocks are to be cached.
ReadHeights read(RasterSet& set, const RasterWindow& window, const ReadOptions& options,
                 HeightDifferences* differences) {
  const auto count =
      static_cast<std::size_t>(window.pixels) * static_cast<std::size_t>(window.lines);
  ReadHeights heights = set.are_floats() ? ReadHeights(no_heights<float>(count))
                                         : ReadHeights(no_heights<double>(count));
  for (const TilePlace& place : set.joined.places) {
    RasterWindow part = common(place.at, window);
    if (part.empty()) continue;
    RasterSource& source = set.sources[place.tile];
    const bool was_open = source.full != nullptr;
    if (!was_open) open_again(source, options);
    const int column = part.pixel - window.pixel, row = part.line - window.line;
    part.pixel -= place.at.pixel;
    part.line -= place.at.line;
    read_part(source, options, part, window.pixels, column, row, heights, differences);
    if (!was_open) close(source);
  }
  return heights;
}

template <class Value>
void leave_in_box(const RasterSet& set, const GridPart& part, std::span<Value> heights) {
  const auto columns = static_cast<std::size_t>(part.columns);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const auto column = part.first_column + static_cast<double>(i % columns),
               row = part.first_row + static_cast<double>(i / columns);
    const Vec2 place = set.order.first + column * set.order.column_step + row * set.order.row_step;
    if (!in_box(set.joined.lattice, place, *set.box))
      heights[i] = std::numeric_limits<Value>::quiet_NaN();
  }
}

} // namespace

ReadHeights read_rows(RasterSet& set, const RowRange& range, const ReadOptions& options,
                      HeightDifferences& differences) {
  return read(set, {set.window.pixel, set.window.line + range.first, set.window.pixels, range.rows},
              options, set.joined.places.size() > 1 ? &differences : nullptr);
}

ReadHeights read_part_of_rows(RasterSet& set, const GridPart& part, const ReadOptions& options,
                              HeightDifferences& differences) {
  return read(set,
              {set.window.pixel + part.first_column, set.window.line + part.first_row, part.columns,
               part.rows},
              options, &differences);
}

void leave_in_box(const RasterSet& set, const GridPart& part, ReadHeights& heights) {
  if (set.box)
    std::visit([&](auto& values) { leave_in_box(set, part, std::span(values)); }, heights);
}

void leave_in_box(const RasterSet& set, Grid& grid) {
  if (set.box)
    std::visit(
        [&](auto& heights) {
          leave_in_box(set, GridPart{0, 0, grid.columns, grid.rows}, heights.own());
        },
        grid.heights_m);
}

} // namespace orograph
