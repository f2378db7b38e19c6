// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/close_outline.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace orograph {
namespace {

// Ends of strokes, by x.
class Ends {
public:
  explicit Ends(const Layer& layer) {
    for (const Stroke& stroke : layer.strokes) {
      const auto points = layer.points(stroke);
      ends_.insert(ends_.end(), {points.front(), points.back()});
    }
    std::sort(ends_.begin(), ends_.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  }

  bool has(Vec2 p) const {
    auto end = std::lower_bound(ends_.begin(), ends_.end(), p.x - kPageStep_mm,
                                [](Vec2 a, double x) { return a.x < x; });
    for (; end != ends_.end() && end->x <= p.x + kPageStep_mm; ++end)
      if (std::abs(end->y - p.y) <= kPageStep_mm) return true;
    return false;
  }

private:
  std::vector<Vec2> ends_;
};

void append_stroke(const Layer& from, Stroke stroke, Layer& to) {
  const auto copy = [&](const auto& of, auto& into) {
    if (of.empty()) return;
    const auto first = of.begin() + stroke.first_point;
    into.insert(into.end(), first, first + stroke.point_count);
  };
  const auto first_point = static_cast<std::uint32_t>(to.page_mm.size());
  copy(from.page_mm, to.page_mm);
  copy(from.map, to.map);
  copy(from.depths_m, to.depths_m);
  stroke.first_point = first_point;
  to.strokes.push_back(stroke);
}

bool is_at_most(std::span<const Vec2> points, double longest_mm) {
  double mm = 0;
  for (std::size_t i = 1; i < points.size() && mm <= longest_mm; ++i)
    mm += plain_length(points[i] - points[i - 1]);
  return mm <= longest_mm;
}

} // namespace

void close_outline(Layer& outline, Layer& other, double longest_mm) {
  const Ends ends(outline);
  const auto closes = [&](const Stroke& stroke) {
    const auto points = other.points(stroke);
    return ends.has(points.front()) && ends.has(points.back()) && is_at_most(points, longest_mm);
  };
  std::size_t step = 0;
  if (std::ranges::none_of(other.strokes, [&](const Stroke& stroke) {
        throw_if_stopped(step++);
        return closes(stroke);
      }))
    return;
  Layer moved = outline, kept = other;
  moved.clear();
  kept.clear();
  for (const Stroke& stroke : other.strokes) {
    throw_if_stopped(step++);
    append_stroke(other, stroke, closes(stroke) ? moved : kept);
  }
  other = std::move(kept);
  append(outline, moved);
}

} // namespace orograph
