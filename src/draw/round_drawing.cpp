// SPDX-License-Identifier: GPL-3.0-or-later
// In place: `kept` follows `read` through the points, never ahead of it.
#include "draw/round_drawing.hpp"

#include "draw/repeated_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

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

RoundingCounts round_strokes(Layer& layer) {
  RoundingCounts dropped;
  const bool has_map = !layer.map.empty();
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
    if (stroke.point_count < 2) {
      ++dropped.empty_strokes;
      kept_point = first;
    } else {
      layer.strokes[kept_stroke++] = stroke;
    }
  }
  dropped.points = layer.page_mm.size() - kept_point;
  layer.strokes.resize(kept_stroke);
  layer.page_mm.resize(kept_point);
  if (has_map) layer.map.resize(kept_point);
  return dropped;
}

RoundingCounts drop_repeated_strokes(Layer& layer) {
  const std::vector<std::uint32_t> repeated = repeated_strokes(layer);
  RoundingCounts dropped;
  dropped.repeated_strokes = repeated.size();
  if (repeated.empty()) return dropped;
  std::uint32_t points = 0, count = 0;
  const auto move_points = [&](auto& list, const Stroke& stroke) {
    if (list.empty()) return;
    const auto first = list.begin() + stroke.first_point;
    std::copy(first, first + stroke.point_count, list.begin() + points);
  };
  auto next_repeated = repeated.begin();
  for (std::uint32_t i = 0; i < layer.strokes.size(); ++i) {
    if (next_repeated != repeated.end() && *next_repeated == i) {
      ++next_repeated;
      continue;
    }
    Stroke stroke = layer.strokes[i];
    move_points(layer.page_mm, stroke);
    move_points(layer.map, stroke);
    stroke.first_point = points;
    points += stroke.point_count;
    layer.strokes[count++] = stroke;
  }
  dropped.points = layer.page_mm.size() - points;
  layer.strokes.resize(count);
  layer.page_mm.resize(points);
  if (!layer.map.empty()) layer.map.resize(points);
  return dropped;
}

RoundingCounts round_to_page_step(Layer& layer) {
  RoundingCounts dropped = round_strokes(layer);
  const RoundingCounts repeated = drop_repeated_strokes(layer);
  dropped.points += repeated.points;
  dropped.repeated_strokes = repeated.repeated_strokes;
  return dropped;
}

} // namespace orograph
