// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/write/device_drawings.hpp"

#include "draw/round_drawing.hpp"
#include "tests/support/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace orograph {

Drawing random_strokes(std::uint64_t seed, const Page& page, const Box2& inside_mm, int pens) {
  Random random(seed);
  const auto place = [&] {
    return Vec2{random.between(inside_mm.low.x, inside_mm.high.x),
                random.between(inside_mm.low.y, inside_mm.high.y)};
  };
  Drawing drawing;
  drawing.page = page;
  const int layers = random.whole(1, 3);
  for (int l = 0; l < layers; ++l) {
    Layer layer;
    layer.name = fmt::format("layer{}", l);
    if (pens > 0) layer.pen = Pen{.number = random.whole(1, pens)};
    Vec2 last = place();
    for (int s = 0; s < 12; ++s) {
      const int kind = random.whole(0, 4);
      std::vector<Vec2> points{kind == 0 ? last : place()};
      const int count = kind == 1 ? 400 : random.whole(2, 7);
      const double step_mm = kind == 2 ? 0.01 : kind == 1 ? 1 : 40;
      while (static_cast<int>(points.size()) < count) {
        const Vec2 next = points.back() + Vec2{random.between(-step_mm, step_mm),
                                               random.between(-step_mm, step_mm)};
        points.push_back({std::clamp(next.x, inside_mm.low.x, inside_mm.high.x),
                          std::clamp(next.y, inside_mm.low.y, inside_mm.high.y)});
      }
      for (Vec2& p : points) p = {rounded_to_page_step(p.x), rounded_to_page_step(p.y)};
      layer.strokes.push_back({.first_point = static_cast<std::uint32_t>(layer.page_mm.size()),
                               .point_count = static_cast<std::uint32_t>(points.size())});
      layer.page_mm.insert(layer.page_mm.end(), points.begin(), points.end());
      last = points.back();
    }
    drawing.layers.push_back(layer);
  }
  return drawing;
}

std::string fault_of_moves(const Drawing& drawing, const std::vector<SeenMove>& moves,
                           const std::function<Vec2(Vec2 page_mm)>& to_device,
                           double tolerance_mm) {
  std::size_t next = 0;
  const auto near = [&](Vec2 a, Vec2 b) {
    return std::abs(a.x - b.x) <= tolerance_mm && std::abs(a.y - b.y) <= tolerance_mm;
  };
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes) {
      const std::span<const Vec2> points = layer.points(stroke);
      std::size_t drawn = 0;
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2 from = to_device(points[i]), to = to_device(points[i + 1]);
        if (next < moves.size() && near(moves[next].from, from) && near(moves[next].to, to)) {
          if (moves[next].pen != (layer.pen ? layer.pen->number : 1))
            return fmt::format("move {} is by pen {}", next, moves[next].pen);
          ++next;
          ++drawn;
        } else if (std::abs(from.x - to.x) > 2 * tolerance_mm ||
                   std::abs(from.y - to.y) > 2 * tolerance_mm) {
          return fmt::format("a segment from {},{} to {},{} isn't move {}", from.x, from.y, to.x,
                             to.y, next);
        }
      }
      if (drawn > 0) continue;
      if (next >= moves.size() || !near(moves[next].from, to_device(points.front())))
        return "a dot is missing";
      ++next;
    }
  return next == moves.size() ? "" : fmt::format("{} moves more", moves.size() - next);
}

} // namespace orograph
