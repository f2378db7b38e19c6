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

namespace {

// How far along the moves the pen may be, once it has drawn some of the drawing's points: at the
// beginning (2k) or the end (2k + 1) of move k, rising. Several where points are closer to each
// other than the pen's own places.
class PenPlaces {
public:
  PenPlaces(const std::vector<SeenMove>& moves, double tolerance_mm)
      : moves_(moves), tolerance_mm_(tolerance_mm) {}

  // A stroke begins where the pen is already, or where its next move does.
  void begin(Vec2 at, int pen) {
    std::vector<std::size_t> next;
    if (places_.empty() && is_near(0, at, pen)) next = {0};
    for (const std::size_t place : places_)
      for (const std::size_t to : {place, place + 1})
        if (place % 2 == 1 && is_near(to, at, pen)) next.push_back(to);
    keep(next);
  }
  void draw_to(Vec2 at, int pen) {
    std::vector<std::size_t> next;
    for (const std::size_t place : places_) {
      const bool goes_on =
          place % 2 == 1 && place + 1 < 2 * moves_.size() && of(place) == of(place + 1);
      for (const std::size_t to : {place, goes_on ? place + 2 : place + 1 - place % 2})
        if (is_near(to, at, pen)) next.push_back(to);
    }
    keep(next);
  }
  bool is_lost() const { return places_.empty(); }
  std::size_t farthest() const { return places_.back(); }

private:
  Vec2 of(std::size_t place) const {
    return place % 2 == 0 ? moves_[place / 2].from : moves_[place / 2].to;
  }
  bool is_near(std::size_t place, Vec2 at, int pen) const {
    if (place >= 2 * moves_.size() || moves_[place / 2].pen != pen) return false;
    const Vec2 there = of(place);
    return std::abs(there.x - at.x) <= tolerance_mm_ && std::abs(there.y - at.y) <= tolerance_mm_;
  }
  void keep(std::vector<std::size_t>& next) {
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    places_ = next;
  }

  const std::vector<SeenMove>& moves_;
  double tolerance_mm_;
  std::vector<std::size_t> places_;
};

} // namespace

std::string fault_of_moves(const Drawing& drawing, const std::vector<SeenMove>& moves,
                           const std::function<Vec2(Vec2 page_mm)>& to_device,
                           double tolerance_mm) {
  PenPlaces places(moves, tolerance_mm);
  bool has_begun = false;
  for (const Layer& layer : drawing.layers)
    for (std::size_t s = 0; s < layer.strokes.size(); ++s) {
      const std::span<const Vec2> points = layer.points(layer.strokes[s]);
      const int pen = layer.pen ? layer.pen->number : 1;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t before = has_begun ? places.farthest() : 0;
        if (i == 0)
          places.begin(to_device(points[i]), pen);
        else
          places.draw_to(to_device(points[i]), pen);
        has_begun = true;
        if (places.is_lost())
          return fmt::format("{}: point {} of stroke {} isn't drawn behind move {}", layer.name, i,
                             s, before / 2);
      }
    }
  const std::size_t drawn = has_begun ? places.farthest() + 1 : 0;
  return drawn == 2 * moves.size() ? "" : fmt::format("{} moves more", moves.size() - drawn / 2);
}

} // namespace orograph
