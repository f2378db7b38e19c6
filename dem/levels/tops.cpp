// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/tops.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <variant>

namespace orograph {
namespace {

constexpr Top kNoTop{-std::numeric_limits<double>::infinity(), 0, 0};

std::size_t squares_along(int vertices, int side) {
  return static_cast<std::size_t>((vertices + side - 1) / side);
}

// Minus infinity where there is none. Several at a time, as each comparison waits for the last.
template <class Height>
Height highest_of(std::span<const Height> heights) {
  constexpr std::size_t kLanes = 32;
  std::array<Height, kLanes> highest{};
  highest.fill(-std::numeric_limits<Height>::infinity());
  const auto take = [&](Height height, std::size_t lane) { // none for NaN
    highest[lane] = height > highest[lane] ? height : highest[lane];
  };
  const std::size_t even = heights.size() - heights.size() % kLanes;
  for (std::size_t i = 0; i < even; i += kLanes)
    for (std::size_t lane = 0; lane < kLanes; ++lane) take(heights[i + lane], lane);
  for (std::size_t i = even; i < heights.size(); ++i) take(heights[i], i - even);
  return *std::ranges::max_element(highest);
}

template <class IsTop>
std::vector<Top> highest_apart(std::vector<Top> squares, int side, std::size_t most,
                               const IsTop& is_top_of_square) {
  std::sort(squares.begin(), squares.end(), [](const Top& a, const Top& b) {
    return std::tuple(-a.height_m, a.row, a.column) < std::tuple(-b.height_m, b.row, b.column);
  });
  std::vector<Top> tops, taken;
  for (const Top& highest : squares) {
    if (tops.size() == most || !std::isfinite(highest.height_m)) break;
    const bool is_apart = std::none_of(taken.begin(), taken.end(), [&](const Top& other) {
      return std::abs(other.column - highest.column) < side &&
             std::abs(other.row - highest.row) < side;
    });
    // The highest of its square may stand on a slope that goes on rising in the next one.
    taken.push_back(highest);
    if (is_apart && is_top_of_square(highest)) tops.push_back(highest);
  }
  return tops;
}

} // namespace

std::vector<Top> tops_of(const Grid& grid, int side, std::size_t most) {
  TopsInRows tops(grid.columns, grid.rows, side);
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        const auto line = [&](int row) {
          const auto width = static_cast<std::size_t>(grid.columns);
          return row < 0 || row >= grid.rows
                     ? std::span<const Height>()
                     : std::span(heights.data() + grid.index(0, row), width);
        };
        on_all_cores(squares_along(grid.rows, side), [&](std::size_t band) {
          const int first = static_cast<int>(band) * side, end = std::min(first + side, grid.rows);
          for (int row = first; row < end; ++row)
            tops.add(row, line(row - 1), line(row), line(row + 1));
        });
      },
      grid.heights_m);
  return tops.tops(most);
}

TopsInRows::TopsInRows(int columns, int rows, int side)
    : side_(side), across_(squares_along(columns, side)),
      squares_(across_ * squares_along(rows, side), {kNoTop, false}) {}

template <class Height>
void TopsInRows::add(int row, std::span<const Height> above, std::span<const Height> line,
                     std::span<const Height> below) {
  Highest* const squares = squares_.data() + static_cast<std::size_t>(row / side_) * across_;
  const auto width = static_cast<int>(line.size());
  const auto none_is_higher = [&](int column, double height) {
    for (const std::span<const Height> beside : {above, line, below})
      for (int c = std::max(column - 1, 0); c <= std::min(column + 1, width - 1); ++c)
        if (!beside.empty() && beside[static_cast<std::size_t>(c)] > height) return false;
    return true;
  };
  for (int first = 0; first < width; first += side_) {
    Highest& square = squares[first / side_];
    const auto begin = line.begin() + first, end = line.begin() + std::min(first + side_, width);
    const Height highest = highest_of(std::span(begin, end));
    if (!(highest > square.at.height_m)) continue;
    const auto column = static_cast<int>(std::find(begin, end, highest) - line.begin());
    square = {{highest, column, row}, none_is_higher(column, highest)};
  }
}

std::vector<Top> TopsInRows::tops(std::size_t most) const {
  std::vector<Top> squares;
  for (const Highest& square : squares_) squares.push_back(square.at);
  const auto side = static_cast<std::size_t>(side_);
  return highest_apart(std::move(squares), side_, most, [&](const Top& highest) {
    return squares_[static_cast<std::size_t>(highest.row) / side * across_ +
                    static_cast<std::size_t>(highest.column) / side]
        .is_top;
  });
}

template void TopsInRows::add(int, std::span<const float>, std::span<const float>,
                              std::span<const float>);
template void TopsInRows::add(int, std::span<const double>, std::span<const double>,
                              std::span<const double>);

} // namespace orograph
