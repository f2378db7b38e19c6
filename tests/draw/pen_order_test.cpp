// SPDX-License-Identifier: GPL-3.0-or-later
// Order changes no ink. Random strokes on small lattices, where ends meet, strokes close and
// segments lie upon each other, and anywhere.
#include "draw/pen_order.hpp"
#include "geometry/on_all_cores.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "tests/support/ink.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace orograph::pen_order_test {
namespace {

const std::uint64_t kDrawings = last_seed(2000);
constexpr PenOrder kOrders[] = {PenOrder::drawing, PenOrder::sorted, PenOrder::best};

Layer random_layer(Random& random) {
  Layer layer = empty_layer("made", 0.2, 0.5);
  layer.is_hidden = random.chance(0.5);
  const int lattice = random.pick({2, 4, 0}), kinds = random.whole(1, 3),
            count = random.pick({0, 1, 2, random.whole(0, 60)});
  for (int s = 0; s < count; ++s) {
    Stroke stroke{.first_point = static_cast<std::uint32_t>(layer.page_mm.size()),
                  .profile = random.chance(0.5) ? -1 : random.whole(0, 1),
                  .width_mm = 0.1 * random.whole(0, kinds - 1)};
    if (random.chance(0.1)) stroke.darkness = 0.5F;
    const int points = random.whole(2, 5);
    for (int i = 0; i < points; ++i) {
      Vec2 p;
      do // strokes have no point twice in a row
        p = lattice == 0 ? Vec2{1e-4 * random.whole(0, 1000000), 1e-4 * random.whole(0, 1000000)}
                         : Vec2{1.0 * random.whole(0, lattice), 1.0 * random.whole(0, lattice)};
      while (i > 0 && p == layer.page_mm.back());
      layer.page_mm.push_back(p);
    }
    if (points > 2 && random.chance(0.2) &&
        layer.page_mm[stroke.first_point] != layer.page_mm.back())
      layer.page_mm.push_back(Vec2(layer.page_mm[stroke.first_point]));
    stroke.point_count = static_cast<std::uint32_t>(layer.page_mm.size()) - stroke.first_point;
    layer.strokes.push_back(stroke);
  }
  return layer;
}

Drawing random_drawing(Random& random) {
  Drawing drawing;
  const int layers = random.whole(1, 3);
  for (int i = 0; i < layers; ++i) drawing.layers.push_back(random_layer(random));
  return drawing;
}

using Place = std::pair<double, double>;
using Kind = std::tuple<double, int, bool>;

Place begin_of(const Layer& layer, const Stroke& stroke) {
  return {layer.points(stroke).front().x, layer.points(stroke).front().y};
}
Place end_of(const Layer& layer, const Stroke& stroke) {
  return {layer.points(stroke).back().x, layer.points(stroke).back().y};
}
// Stroke after stroke.
std::vector<Vec2> points_of(const Layer& layer) {
  std::vector<Vec2> points;
  for (const Stroke& stroke : layer.strokes)
    points.insert(points.end(), layer.points(stroke).begin(), layer.points(stroke).end());
  return points;
}
Kind kind_of(const Stroke& stroke) {
  return {stroke.width_mm, stroke.profile, stroke.darkness > 0};
}

} // namespace

TEST_CASE("whatever the order, each segment is drawn as often and as wide as before") {
  std::size_t fewer = 0;
  for (std::uint64_t seed = 1; seed <= kDrawings; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const Drawing drawing = random_drawing(random);
    for (const PenOrder order : kOrders) {
      Drawing ordered = drawing;
      order_for_pen(ordered, order);
      REQUIRE(ordered.layers.size() == drawing.layers.size());
      for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
        const Layer &before = drawing.layers[i], &after = ordered.layers[i];
        CHECK(after.name == before.name);
        CHECK(after.pen_width_mm == before.pen_width_mm);
        CHECK(after.grey == before.grey);
        CHECK(after.is_hidden == before.is_hidden);
        CHECK((ink_of(after) == ink_of(before)));
        std::vector<int> times(after.page_mm.size());
        for (const Stroke& stroke : after.strokes)
          for (std::uint32_t p = 0; p < stroke.point_count; ++p) ++times.at(stroke.first_point + p);
        CHECK(std::ranges::all_of(times, [](int n) { return n == 1; }));
        fewer += before.strokes.size() - after.strokes.size();
      }
    }
  }
  CHECK(fewer > kDrawings);
}

TEST_CASE("no two ends of a kind are left at a place, and what touches is drawn without a lift") {
  std::size_t touching = 0;
  for (std::uint64_t seed = 1; seed <= kDrawings; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    Drawing drawing = random_drawing(random);
    std::vector<std::map<std::pair<Place, Kind>, int>> ends_before;
    for (const Layer& layer : drawing.layers) {
      auto& ends = ends_before.emplace_back();
      for (const Stroke& stroke : layer.strokes) {
        ++ends[{begin_of(layer, stroke), kind_of(stroke)}];
        ++ends[{end_of(layer, stroke), kind_of(stroke)}];
      }
    }
    order_for_pen(drawing, seed % 2 == 0 ? PenOrder::sorted : PenOrder::best);
    for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
      const Layer& layer = drawing.layers[i];
      std::map<std::pair<Place, Kind>, int> ends;
      std::map<Place, int> loose; // where a line begins or ends
      for (std::size_t s = 0; s < layer.strokes.size();) {
        const Stroke& first = layer.strokes[s];
        const Place begin = begin_of(layer, first);
        Place end = begin;
        do { // a line without a lift
          const Stroke& stroke = layer.strokes[s++];
          if (begin_of(layer, stroke) != end_of(layer, stroke)) {
            ++ends[{begin_of(layer, stroke), kind_of(stroke)}];
            ++ends[{end_of(layer, stroke), kind_of(stroke)}];
          }
          end = end_of(layer, stroke);
          if (s < layer.strokes.size() && begin_of(layer, layer.strokes[s]) == end) ++touching;
        } while (s < layer.strokes.size() && begin_of(layer, layer.strokes[s]) == end);
        if (begin != end) {
          ++loose[begin];
          ++loose[end];
        }
      }
      bool one_at_most = true, same_parity = true;
      for (const auto& [at, times] : ends) one_at_most &= times <= 1;
      CHECK(one_at_most);
      for (const auto& [at, times] : loose) same_parity &= times <= 1;
      CHECK(same_parity);
      for (const auto& [at, times] : ends_before[i]) {
        const auto found = ends.find(at);
        if (times % 2 == 1) CHECK((found != ends.end() && found->second == 1));
      }
    }
  }
  CHECK(touching > kDrawings);
}

TEST_CASE("a layer begins near where the one before it ends") {
  Drawing drawing;
  drawing.layers = {empty_layer("one"), empty_layer("none"), empty_layer("two")};
  add_stroke(drawing.layers[0], {{1, 1}, {50, 50}});
  add_stroke(drawing.layers[2], {{2, 1}, {3, 1}});
  add_stroke(drawing.layers[2], {{40, 50}, {49, 50}});
  order_for_pen(drawing, PenOrder::sorted);
  const Layer& two = drawing.layers[2];
  CHECK(two.points(two.strokes[0]).front() == Vec2{49, 50});
  CHECK(two.points(two.strokes[1]).front() == Vec2{3, 1});
  CHECK(std::abs(pen_travels(drawing).all.up_mm - (std::sqrt(2) + 1 + std::hypot(37, 49))) < 1e-9);
}

TEST_CASE("a closed stroke begins where the pen is nearest") {
  Drawing drawing;
  drawing.layers = {empty_layer("ring")};
  add_stroke(drawing.layers[0], {{20, 20}, {30, 20}, {30, 30}, {10, 12}, {20, 20}});
  order_for_pen(drawing, PenOrder::sorted);
  CHECK((points_of(drawing.layers[0]) ==
         std::vector<Vec2>{{10, 12}, {20, 20}, {30, 20}, {30, 30}, {10, 12}}));
}

TEST_CASE("a line that changes its width is drawn in one go, from either end") {
  Drawing drawing;
  drawing.layers = {empty_layer("line")};
  Layer& layer = drawing.layers[0];
  add_stroke(layer, {{90, 90}, {80, 90}});
  add_stroke(layer, {{80, 90}, {70, 90}, {60, 90}});
  add_stroke(layer, {{60, 90}, {50, 90}});
  add_stroke(layer, {{75, 10}, {75, 85}});
  layer.strokes[0].width_mm = layer.strokes[2].width_mm = 0.1;
  layer.strokes[1].width_mm = 0.2;
  order_for_pen(drawing, PenOrder::sorted);
  REQUIRE(layer.strokes.size() == 4);
  CHECK((points_of(layer) == std::vector<Vec2>{{75, 10},
                                               {75, 85},
                                               {90, 90},
                                               {80, 90},
                                               {80, 90},
                                               {70, 90},
                                               {60, 90},
                                               {60, 90},
                                               {50, 90}}));
  CHECK(layer.strokes[2].width_mm == 0.2);
}

TEST_CASE("a drawing is ordered alike on any number of threads") {
  for (std::uint64_t seed = 1; seed <= last_seed(50); ++seed) {
    Random random(seed);
    Drawing one = random_drawing(random);
    Drawing many = one;
    on_cores(1, {}, [&] { order_for_pen(one, PenOrder::best); });
    on_cores(0, {}, [&] { order_for_pen(many, PenOrder::best); });
    for (std::size_t i = 0; i < one.layers.size(); ++i)
      CHECK((points_of(one.layers[i]) == points_of(many.layers[i])));
  }
}

} // namespace orograph::pen_order_test
