// SPDX-License-Identifier: GPL-3.0-or-later
// Adding up the pen's ways.
#include "draw/pen_travel.hpp"

namespace orograph {

PenTravel pen_travel(const Drawing& drawing) {
  PenTravel travel;
  Vec2 pen{0, 0};
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes) {
      const std::span<const Vec2> points = layer.points(stroke);
      travel.up_mm += length(points.front() - pen);
      for (std::size_t i = 1; i < points.size(); ++i)
        travel.down_mm += length(points[i] - points[i - 1]);
      pen = points.back();
    }
  return travel;
}

} // namespace orograph
