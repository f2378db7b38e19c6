// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/departure.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace orograph {

namespace {

// Of a row, a power of two: it stays in the processor's nearest cache.
constexpr std::size_t kBlock = 512;

// The drawn heights of part of a row. Between two columns of the level, and on one side of the
// diagonal, they are straight: a beginning and a slope for each cell and side, which is a third of
// the work of three shares for each height.
template <class Height>
void lay_row(std::span<const PlaceInLevel> across, std::span<const Height> upper,
             std::span<const Height> lower, double y, double* drawn) {
  int current = -1;
  bool has_void = false;
  double north_west = 0, north_east = 0, south_west = 0, south_east = 0;
  double of_upper = 0, of_lower = 0, slope_upper = 0, slope_lower = 0;
  for (std::size_t i = 0; i < across.size(); ++i) {
    const auto [cell, x] = across[i];
    if (cell != current) {
      current = cell;
      const auto at = static_cast<std::size_t>(cell);
      north_west = upper[at], north_east = upper[at + 1];
      south_west = lower[at], south_east = lower[at + 1];
      of_upper = north_west + y * (south_east - north_east), slope_upper = north_east - north_west;
      of_lower = north_west + y * (south_west - north_west), slope_lower = south_east - south_west;
      has_void = std::isnan(of_upper + of_lower);
    }
    if (has_void) // a corner without a share in it doesn't count
      drawn[i] = height_in_cell(north_west, north_east, south_west, south_east, x, y);
    else
      drawn[i] = x > y ? of_upper + x * slope_upper : of_lower + x * slope_lower;
  }
}

// Folded by halves: plain loops over arrays, which the processor does several at a time.
template <class Height>
void add_block(std::array<double, kBlock>& drawn, std::span<const Height> row, RowDeparture& sum) {
  std::array<double, kBlock> squares;
  for (std::size_t i = 0; i < row.size(); ++i) drawn[i] = std::abs(drawn[i] - row[i]);
  std::fill(drawn.begin() + static_cast<std::ptrdiff_t>(row.size()), drawn.end(), 0);
  for (std::size_t i = 0; i < kBlock; ++i) squares[i] = drawn[i] * drawn[i];
  std::uint64_t count = row.size();
  for (std::size_t half = kBlock / 2; half > 0; half /= 2)
    for (std::size_t i = 0; i < half; ++i) squares[i] += squares[i + half];
  if (std::isnan(squares[0])) { // there are voids
    count = 0;
    squares[0] = 0;
    for (std::size_t i = 0; i < row.size(); ++i)
      if (std::isnan(drawn[i])) {
        drawn[i] = 0;
      } else {
        squares[0] += drawn[i] * drawn[i];
        ++count;
      }
  }
  for (std::size_t half = kBlock / 2; half > 0; half /= 2)
    for (std::size_t i = 0; i < half; ++i)
      drawn[i] = drawn[i] > drawn[i + half] ? drawn[i] : drawn[i + half];
  sum.greatest_m = std::max(sum.greatest_m, drawn[0]);
  sum.squares += squares[0];
  sum.count += count;
}

} // namespace

std::vector<PlaceInLevel> places_in_level(int vertices, int of_level) {
  std::vector<PlaceInLevel> out;
  const double step = (of_level - 1.0) / (vertices - 1);
  for (int i = 0; i < vertices; ++i) {
    const int cell = std::min(static_cast<int>(i * step), of_level - 2);
    out.push_back({cell, i * step - cell});
  }
  return out;
}

template <class Height>
RowDeparture departure_of_row(std::span<const Height> row, std::span<const Height> upper,
                              std::span<const Height> lower, double share,
                              const std::vector<PlaceInLevel>& across) {
  RowDeparture sum;
  std::array<double, kBlock> drawn{};
  for (std::size_t first = 0; first < across.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, across.size() - first);
    lay_row(std::span(across).subspan(first, count), upper, lower, share, drawn.data());
    add_block(drawn, row.subspan(first, count), sum);
  }
  return sum;
}

Departure departure_of(const std::vector<RowDeparture>& rows) {
  RowDeparture all;
  for (const RowDeparture& row : rows) {
    all.greatest_m = std::max(all.greatest_m, row.greatest_m);
    all.squares += row.squares;
    all.count += row.count;
  }
  Departure departure{.greatest_m = all.greatest_m};
  if (all.count > 0) departure.rms_m = std::sqrt(all.squares / static_cast<double>(all.count));
  return departure;
}

Departure departure_of(const Grid& level, const Grid& grid) {
  const std::vector<PlaceInLevel> across = places_in_level(grid.columns, level.columns),
                                  down = places_in_level(grid.rows, level.rows);
  std::vector<RowDeparture> rows(down.size());
  std::visit(
      [&](const auto& heights) {
        using Heights = std::remove_cvref_t<decltype(heights)>;
        const auto line = [](const Grid& of, const Heights& in, int row) {
          return std::span(in.data() + of.index(0, row), static_cast<std::size_t>(of.columns));
        };
        const auto& of_level = std::get<Heights>(level.heights_m);
        on_all_cores(rows.size(), [&](std::size_t j) {
          const auto [cell, share] = down[j];
          rows[j] = departure_of_row(line(grid, heights, static_cast<int>(j)),
                                     line(level, of_level, cell), line(level, of_level, cell + 1),
                                     share, across);
        });
      },
      grid.heights_m);
  return departure_of(rows);
}

template RowDeparture departure_of_row(std::span<const float>, std::span<const float>,
                                       std::span<const float>, double,
                                       const std::vector<PlaceInLevel>&);
template RowDeparture departure_of_row(std::span<const double>, std::span<const double>,
                                       std::span<const double>, double,
                                       const std::vector<PlaceInLevel>&);

} // namespace orograph
