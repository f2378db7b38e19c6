// SPDX-License-Identifier: GPL-3.0-or-later
// What of a layer is on paper, whatever the order and the way of the strokes.
#pragma once

#include "draw/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace orograph {

/// A segment between two places in steps of the page, the lower first, and how wide it is drawn.
using InkSegment = std::tuple<std::pair<long, long>, std::pair<long, long>, double>;

/// All of a layer, sorted.
inline std::vector<InkSegment> ink_of(const Layer& layer) {
  const auto in_steps = [](Vec2 p) {
    return std::pair(std::lround(p.x / kPageStep_mm), std::lround(p.y / kPageStep_mm));
  };
  std::vector<InkSegment> ink;
  for (const Stroke& stroke : layer.strokes) {
    const auto points = layer.points(stroke);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto [low, high] = std::minmax({in_steps(points[i - 1]), in_steps(points[i])});
      ink.emplace_back(low, high, stroke.width_mm);
    }
  }
  std::sort(ink.begin(), ink.end());
  return ink;
}

} // namespace orograph
