// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/height_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace orograph {
namespace {

// Lanes, because a single running minimum or sum has to be taken in order and therefore doesn't
// vectorize. Comparisons with NaN are false.
template <class Value>
HeightRange range_of(const Heights<Value>& heights) {
  constexpr std::size_t kLanes = 16;
  std::array<Value, kLanes> low, high;
  std::array<double, kLanes> sum{}, count{};
  low.fill(std::numeric_limits<Value>::infinity());
  high.fill(-std::numeric_limits<Value>::infinity());
  const auto take = [&](Value h, std::size_t lane) {
    low[lane] = h < low[lane] ? h : low[lane];
    high[lane] = h > high[lane] ? h : high[lane];
    sum[lane] += static_cast<double>(h == h ? h : Value{0});
    count[lane] += h == h ? 1 : 0;
  };
  const std::size_t whole = heights.size() / kLanes * kLanes;
  for (std::size_t i = 0; i < whole; i += kLanes)
    for (std::size_t lane = 0; lane < kLanes; ++lane) take(heights[i + lane], lane);
  for (std::size_t i = whole; i < heights.size(); ++i) take(heights[i], 0);
  double total = 0, valid = 0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    total += sum[lane];
    valid += count[lane];
  }
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end()),
          total / valid};
}

} // namespace

HeightRange height_range(const Grid& grid) {
  return std::visit([](const auto& heights) { return range_of(heights); }, grid.heights_m);
}

} // namespace orograph
