// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/ground_around.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace orograph {
namespace {

// A straight ridge bends by as much as the ground around rises and falls; noise by far less. From
// the first share on it counts as one, at the second fully.
constexpr double kSomeRidge = 0.15, kFullRidge = 0.5;
// How far a ridge goes back to the highest ground: all the way would bring its noise back.
constexpr double kAddedBack = 0.8;

// Whether there may be one: a sum is NaN where one of many is, and several are made at a time.
template <class Height>
bool may_have_void(std::span<const Height> line) {
  constexpr std::size_t kSums = 64;
  std::array<Height, kSums> sums{};
  const std::size_t even = line.size() - line.size() % kSums;
  for (std::size_t first = 0; first < even; first += kSums)
    for (std::size_t i = 0; i < kSums; ++i) sums[i] += line[first + i];
  for (std::size_t i = even; i < line.size(); ++i) sums[i - even] += line[i];
  return std::ranges::any_of(sums, [](Height sum) { return std::isnan(sum); });
}

} // namespace

template <class Height>
void RowGathering<Height>::begin(const LevelWindow& window) {
  window_ = window;
  weight_ = 0;
  weights_.clear();
  sum_.clear();
}

template <class Height>
void RowGathering<Height>::add(std::span<const Height> line, int row) {
  constexpr Height kFar = std::numeric_limits<Height>::infinity();
  const std::size_t width = line.size();
  if (sum_.empty()) {
    sum_.assign(width, 0);
    low_.assign(width, kFar);
    high_.assign(width, -kFar);
  }
  const double share = window_.weight(row);
  if (weights_.empty() && may_have_void(line)) weights_.assign(width, weight_);
  double* const sum = sum_.data();
  if (weights_.empty()) {
    for (std::size_t c = 0; c < width; ++c) sum[c] += share * line[c];
    weight_ += share;
  } else {
    double* const weights = weights_.data();
    for (std::size_t c = 0; c < width; ++c) {
      const double height = line[c];
      const bool is_there = height == height;
      sum[c] += is_there ? share * height : 0;
      weights[c] += is_there ? share : 0;
    }
  }
  if (row < window_.first_near || row > window_.last_near) return;
  Height* const low = low_.data();
  Height* const high = high_.data();
  for (std::size_t c = 0; c < width; ++c) { // comparisons with NaN are false
    low[c] = line[c] < low[c] ? line[c] : low[c];
    high[c] = line[c] > high[c] ? line[c] : high[c];
  }
}

template <class Height>
AroundRow RowGathering<Height>::around(std::span<const Height> nearest,
                                       const std::vector<LevelWindow>& columns) const {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> none(columns.size() + 2, kNone);
  AroundRow out{none, none, none};
  for (std::size_t i = 1; i <= columns.size(); ++i) {
    const LevelWindow& column = columns[i - 1];
    if (std::isnan(nearest[static_cast<std::size_t>(column.nearest())])) continue;
    double total = 0, of_weights = 0;
    for (int c = column.first; c <= column.last; ++c) {
      const double share = column.weight(c);
      total += share * sum_[static_cast<std::size_t>(c)];
      of_weights += share * (weights_.empty() ? weight_ : weights_[static_cast<std::size_t>(c)]);
    }
    out.mean[i] = total / of_weights;
    const auto near = [&](const std::vector<Height>& values) {
      return std::pair(values.begin() + column.first_near, values.begin() + column.last_near + 1);
    };
    const auto lows = near(low_), highs = near(high_);
    out.lowest[i] = *std::min_element(lows.first, lows.second);
    out.highest[i] = *std::max_element(highs.first, highs.second);
  }
  return out;
}

// Without a branch, so that the compiler reckons several vertices at a time; comparisons with NaN
// are false.
std::vector<double> heights_with_character(std::span<const AroundRow> rows, std::size_t row) {
  const std::size_t width = rows[row].mean.size();
  const std::vector<double> none(row > 0 && row + 1 < rows.size() ? 0 : width,
                                 std::numeric_limits<double>::quiet_NaN());
  const AroundRow beyond{none, none, none};
  const AroundRow& row_above = row > 0 ? rows[row - 1] : beyond;
  const AroundRow& row_below = row + 1 < rows.size() ? rows[row + 1] : beyond;
  struct Line {
    const double *mean, *highest;
  };
  const Line above{row_above.mean.data(), row_above.highest.data()},
      here{rows[row].mean.data(), rows[row].highest.data()},
      below{row_below.mean.data(), row_below.highest.data()};
  const double* const lowest = rows[row].lowest.data();
  std::vector<double> out(width - 2);
  for (std::size_t i = 1; i + 1 < width; ++i) {
    const double mean = here.mean[i], low = lowest[i], high = here.highest[i];
    // By how much it is above what lies on both sides; a slope isn't.
    double bend = 0, ways = 0;
    bool is_summit = true;
    const auto look = [&](const Line& first, std::size_t at_first, const Line& second,
                          std::size_t at_second) {
      const double before = first.mean[at_first], behind = second.mean[at_second];
      const double bend_here = mean - 0.5 * (before + behind);
      const bool has_both = bend_here == bend_here;
      bend += has_both ? bend_here : 0;
      ways += has_both ? 1 : 0;
      // Of vertices of one height the first is the summit.
      is_summit = is_summit & !(first.highest[at_first] > high) &
                  !(second.highest[at_second] > high) & !(before >= mean) & !(behind > mean);
    };
    look(here, i - 1, here, i + 1);
    look(above, i, below, i);
    look(above, i - 1, below, i + 1);
    look(above, i + 1, below, i - 1);
    const double ridge = std::abs(bend / (ways * (high - low)));
    double share = (ridge - kSomeRidge) / (kFullRidge - kSomeRidge);
    share = share > 0 ? share : 0;
    share = share < 1 ? share : 1;
    double height = mean + kAddedBack * share * ((bend > 0 ? high : low) - mean);
    height = is_summit ? high : height;
    out[i - 1] = ((ways > 0) & (high > low)) ? height : mean;
  }
  return out;
}

template class RowGathering<float>;
template class RowGathering<double>;

} // namespace orograph
