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
  const std::size_t across = columns.size();
  AroundRow out{std::vector<double>(across, kNone), std::vector<double>(across, kNone),
                std::vector<double>(across, kNone)};
  for (std::size_t i = 0; i < across; ++i) {
    const LevelWindow& column = columns[i];
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

double height_with_character(const std::vector<AroundRow>& rows, int column, int row) {
  const auto at = static_cast<std::size_t>(column);
  const AroundRow& here = rows[static_cast<std::size_t>(row)];
  const double mean = here.mean[at], lowest = here.lowest[at], highest = here.highest[at];
  if (!(highest > lowest)) return mean;
  const auto columns = static_cast<int>(here.mean.size()), down_to = static_cast<int>(rows.size());
  // By how much it is above what lies on both sides; a slope isn't.
  double bend = 0;
  int ways = 0;
  bool is_summit = true;
  for (const auto& [across, down] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
    bool is_between = true;
    double beside = 0;
    for (const int side : {-1, 1}) {
      const int c = column + side * across, r = row + side * down;
      const bool is_in = c >= 0 && r >= 0 && c < columns && r < down_to;
      const AroundRow* const other = is_in ? &rows[static_cast<std::size_t>(r)] : nullptr;
      const auto i = static_cast<std::size_t>(c);
      if (!other || std::isnan(other->mean[i])) {
        is_between = false;
        continue;
      }
      beside += other->mean[i];
      const bool is_later = std::pair(row, column) < std::pair(r, c);
      is_summit = is_summit && other->highest[i] <= highest &&
                  (other->mean[i] < mean || (other->mean[i] == mean && is_later));
    }
    if (!is_between) continue;
    bend += mean - 0.5 * beside;
    ++ways;
  }
  if (ways == 0) return mean;
  if (is_summit) return highest;
  bend /= ways * (highest - lowest);
  const double share =
      kAddedBack * std::clamp((std::abs(bend) - kSomeRidge) / (kFullRidge - kSomeRidge), 0.0, 1.0);
  return mean + share * ((bend > 0 ? highest : lowest) - mean);
}

template class RowGathering<float>;
template class RowGathering<double>;

} // namespace orograph
