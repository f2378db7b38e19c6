// SPDX-License-Identifier: GPL-3.0-or-later
// In place: `kept` follows `read` through the points, never ahead of it.
#include "draw/round_drawing.hpp"

#include "draw/stroke_set.hpp"

#include <cmath>

namespace orograph {

double rounded_to_page_step(double x_mm) {
  constexpr double steps_per_mm = 1e4;
  static_assert(1 / kPageStep_mm == steps_per_mm);
  // From here on doubles are whole numbers, so adding it rounds, ties to even. (Without the
  // instruction for it, which not all processors have, std::nearbyint takes several times as long.)
  constexpr double whole_from = 0x1p52;
  const double steps = x_mm * steps_per_mm;
  const double whole = std::copysign(std::abs(steps) + whole_from - whole_from, steps);
  // Dividing the whole number of steps rounds once, to the double nearest to the decimal;
  // multiplying by 1e-4, itself inexact, would not. Adding 0 turns -0 into 0.
  return whole / steps_per_mm + 0.0;
}

RoundingCounts round_to_page_step(Layer& layer) {
  RoundingCounts dropped;
  const bool has_map = !layer.map.empty();
  StrokeSet seen(layer, layer.strokes.size());
  for (Vec2& p : layer.page_mm) p = {rounded_to_page_step(p.x), rounded_to_page_step(p.y)};
  std::uint32_t kept_point = 0, kept_stroke = 0;
  for (Stroke stroke : layer.strokes) {
    const std::uint32_t first = kept_point, end = stroke.first_point + stroke.point_count;
    for (std::uint32_t read = stroke.first_point; read < end; ++read) {
      const Vec2 p = layer.page_mm[read];
      const bool is_new = kept_point == first || p != layer.page_mm[kept_point - 1];
      if (is_new) layer.page_mm[kept_point++] = p;
      if (has_map && (is_new || read + 1 == end)) layer.map[kept_point - 1] = layer.map[read];
    }
    stroke.first_point = first;
    stroke.point_count = kept_point - first;
    layer.strokes[kept_stroke] = stroke;
    if (stroke.point_count < 2)
      ++dropped.empty_strokes;
    else if (!seen.insert(kept_stroke))
      ++dropped.repeated_strokes;
    else {
      ++kept_stroke;
      continue;
    }
    kept_point = first;
  }
  dropped.points = layer.page_mm.size() - kept_point;
  layer.strokes.resize(kept_stroke);
  layer.page_mm.resize(kept_point);
  if (has_map) layer.map.resize(kept_point);
  return dropped;
}

} // namespace orograph
