// SPDX-License-Identifier: GPL-3.0-or-later
// The way of a device's pen through a drawing, whatever the device speaks.
#pragma once

#include "draw/drawing.hpp"
#include "geometry/on_all_cores.hpp"

#include <cstddef>

namespace orograph {

/// Layer by layer `take_pen`, stroke by stroke `draw` and then `hand_on`, whose false ends it at
/// once, where nobody wants more; else `end`.
template <class Text>
void draw_on_device(const Drawing& drawing, Text& text) {
  std::size_t step = 0;
  for (const Layer& layer : drawing.layers) {
    if (layer.is_pen_way || layer.strokes.empty()) continue;
    text.take_pen(layer.pen);
    for (const Stroke& stroke : layer.strokes) {
      throw_if_stopped(step++);
      text.draw(layer.points(stroke));
      if (!text.hand_on()) return;
    }
  }
  text.end();
}

} // namespace orograph
