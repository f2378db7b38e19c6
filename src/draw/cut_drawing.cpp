// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/cut_drawing.hpp"

#include "draw/round_drawing.hpp"
#include "geometry/on_all_cores.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace orograph {
namespace {

// Along a segment, from 0 to 1.
struct Range {
  double begin = 0, end = 1;
};

// Where from + t (to - from) lies between low and high, within `range`.
void keep_between(double from, double to, double low, double high, Range& range) {
  if (from == to) {
    if (from < low || from > high) range.end = -1;
    return;
  }
  double at_low = (low - from) / (to - from), at_high = (high - from) / (to - from);
  if (at_low > at_high) std::swap(at_low, at_high);
  range.begin = std::max(range.begin, at_low);
  range.end = std::min(range.end, at_high);
}

std::optional<Range> part_within(Vec2 a, Vec2 b, const Box2& box) {
  Range range;
  keep_between(a.x, b.x, box.low.x, box.high.x, range);
  keep_between(a.y, b.y, box.low.y, box.high.y, range);
  if (range.begin > range.end) return std::nullopt;
  return range;
}

// On the step, and never beyond the edge that it was cut at.
Vec2 cut_point(Vec2 a, Vec2 b, double t, const Box2& box) {
  const Vec2 p = a + t * (b - a);
  return {std::clamp(rounded_to_page_step(p.x), box.low.x, box.high.x),
          std::clamp(rounded_to_page_step(p.y), box.low.y, box.high.y)};
}

void begin_stroke(Layer& out, const Stroke& like, Vec2 at) {
  out.strokes.push_back(like);
  out.strokes.back().first_point = static_cast<std::uint32_t>(out.page_mm.size());
  out.strokes.back().point_count = 1;
  out.page_mm.push_back(at);
}

void draw_to(Layer& out, Vec2 to) {
  out.page_mm.push_back(to);
  ++out.strokes.back().point_count;
}

void append_parts(Layer& out, std::span<const Vec2> points, const Stroke& like, const Box2& box) {
  bool is_inside = false; // the last point, and so the stroke goes on
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 a = points[i], b = points[i + 1];
    const std::optional<Range> part = part_within(a, b, box);
    if (!part) {
      is_inside = false;
      continue;
    }
    if (!is_inside || part->begin > 0)
      begin_stroke(out, like, part->begin > 0 ? cut_point(a, b, part->begin, box) : a);
    draw_to(out, part->end < 1 ? cut_point(a, b, part->end, box) : b);
    is_inside = part->end >= 1;
  }
}

} // namespace

void cut_to(Drawing& drawing, const Box2& box_mm) {
  std::size_t step = 0;
  for (Layer& layer : drawing.layers) {
    const std::vector<Vec2> points = std::move(layer.page_mm);
    const std::vector<Stroke> strokes = std::move(layer.strokes);
    layer.clear();
    for (const Stroke& stroke : strokes) {
      throw_if_stopped(step++);
      append_parts(layer, std::span(points).subspan(stroke.first_point, stroke.point_count), stroke,
                   box_mm);
    }
    // What only touches an edge has no length, and parts of two strokes may be the same.
    layer.is_pen_way ? round_strokes(layer) : round_to_page_step(layer);
    std::erase_if(layer.texts, [&](const PageText& text) {
      const Box2 box = text.box_mm();
      return box.low.x >= box_mm.high.x || box.high.x <= box_mm.low.x ||
             box.low.y >= box_mm.high.y || box.high.y <= box_mm.low.y;
    });
  }
}

Box2 middle_of(const Page& page, Vec2 size_mm) {
  const Vec2 low{rounded_to_page_step(0.5 * (page.width_mm - size_mm.x)),
                 rounded_to_page_step(0.5 * (page.height_mm - size_mm.y))};
  return {low, {rounded_to_page_step(low.x + size_mm.x), rounded_to_page_step(low.y + size_mm.y)}};
}

} // namespace orograph
