// SPDX-License-Identifier: GPL-3.0-or-later
// The checker of drawings, for tests, debug builds and whoever doubts one.
#include "draw/drawing.hpp"

#include "draw/repeated_strokes.hpp"
#include "draw/round_drawing.hpp"

#include <fmt/format.h>

#include <cmath>

namespace orograph {
namespace {

std::optional<std::string> fault_of_point(Vec2 p, const Box2& inner) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return "is not finite";
  if (rounded_to_page_step(p.x) != p.x || rounded_to_page_step(p.y) != p.y ||
      (p.x == 0 && std::signbit(p.x)) || (p.y == 0 && std::signbit(p.y)))
    return fmt::format("({}, {}) is not on the step of {} mm", p.x, p.y, kPageStep_mm);
  // A point on a margin that is itself off the step may be rounded across it.
  if (p.x < inner.low.x - kPageStep_mm || p.x > inner.high.x + kPageStep_mm ||
      p.y < inner.low.y - kPageStep_mm || p.y > inner.high.y + kPageStep_mm)
    return fmt::format("({}, {}) lies outside the margins", p.x, p.y);
  return {};
}

std::optional<std::string> fault_of_stroke(const Layer& layer, const Stroke& stroke,
                                           const Box2& inner) {
  if (stroke.point_count < 2) return "has fewer than two points";
  if (stroke.first_point > layer.page_mm.size() ||
      stroke.point_count > layer.page_mm.size() - stroke.first_point)
    return "runs past the points of its layer";
  const std::span<const Vec2> points = layer.points(stroke);
  bool has_length = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (const auto fault = fault_of_point(points[i], inner))
      return fmt::format("point {} {}", i, *fault);
    has_length = has_length || points[i] != points[0];
  }
  if (!has_length) return "has no length";
  return {};
}

std::optional<std::string> fault_of_layer(const Layer& layer, const Box2& inner) {
  if (!layer.map.empty() && layer.map.size() != layer.page_mm.size())
    return "has map points that don't match its page points";
  const auto count = static_cast<std::uint32_t>(layer.strokes.size());
  for (std::uint32_t i = 0; i < count; ++i)
    if (const auto fault = fault_of_stroke(layer, layer.strokes[i], inner))
      return fmt::format("stroke {} {}", i, *fault);
  if (const auto repeated = repeated_strokes(layer); !repeated.empty())
    return fmt::format("stroke {} repeats an earlier one", repeated.front());
  for (std::size_t i = 0; i < layer.map.size(); ++i)
    if (const Vec3 p = layer.map[i];
        !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return fmt::format("map point {} is not finite", i);
  return {};
}

} // namespace

std::optional<std::string> find_fault(const Drawing& drawing) {
  for (const Layer& layer : drawing.layers)
    if (const auto fault = fault_of_layer(layer, drawing.page.inner_mm()))
      return fmt::format("layer {}: {}", layer.name, *fault);
  return {};
}

void append(Layer& layer, const Layer& other) {
  const auto offset = static_cast<std::uint32_t>(layer.page_mm.size());
  layer.page_mm.insert(layer.page_mm.end(), other.page_mm.begin(), other.page_mm.end());
  layer.map.insert(layer.map.end(), other.map.begin(), other.map.end());
  for (Stroke stroke : other.strokes) {
    stroke.first_point += offset;
    layer.strokes.push_back(stroke);
  }
}

} // namespace orograph
