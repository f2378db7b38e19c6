// SPDX-License-Identifier: GPL-3.0-or-later
// Each stroke goes to the pen that the definition names, and pens follow each other by where they
// begin.
#include "draw/assign_pens.hpp"
#include "draw/pen_order.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace orograph::assign_pens_test {
namespace {

const std::vector<std::string> kLayers{"profiles", "shores", "border"};

Drawing random_drawing(Random& random) {
  Drawing drawing;
  for (const std::string& name : kLayers) {
    Layer layer = empty_layer(name, random.pick({0.113, 0.157, 0.389}));
    const int strokes = random.whole(0, 8);
    for (int s = 0; s < strokes; ++s) {
      add_stroke(layer, {{1.0 * random.whole(10, 200), 1.0 * random.whole(10, 100)},
                         {1.0 * random.whole(10, 200), 1.0 * random.whole(110, 280)}});
      layer.strokes.back().width_mm = random.pick({0.0, 0.0, 0.123, 0.211, 0.337, 0.503});
    }
    drawing.layers.push_back(layer);
  }
  drawing.layers.push_back(empty_layer("pen-up"));
  drawing.layers.back().is_pen_way = true;
  return drawing;
}

std::vector<PenOfLayers> random_pens(Random& random) {
  std::vector<PenOfLayers> pens;
  const int count = random.whole(1, 5);
  for (int i = 0; i < count; ++i) {
    PenOfLayers one{Pen{.number = i + 1, .width_mm = 0.05 * random.whole(1, 10)}};
    for (const std::string& layer : kLayers)
      if (random.chance(0.3)) one.layers.push_back(layer);
    pens.push_back(one);
  }
  pens.push_back({Pen{.number = 9, .width_mm = 0.2}});
  return pens;
}

// Number of a pen and two points.
using Inked = std::tuple<int, double, double, double, double>;

Inked inked(int pen, std::span<const Vec2> points) {
  return {pen, points[0].x, points[0].y, points[1].x, points[1].y};
}

} // namespace

TEST_CASE("each stroke is drawn by the pen of its layer that is nearest in width") {
  int by_name = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    Drawing drawing = random_drawing(random);
    const std::vector<PenOfLayers> pens = random_pens(random);
    std::vector<Inked> expected, drawn;
    for (const Layer& layer : drawing.layers) {
      const bool is_named = std::ranges::any_of(pens, [&](const PenOfLayers& one) {
        return std::ranges::count(one.layers, layer.name) > 0;
      });
      for (const Stroke& stroke : layer.strokes) {
        const double width = stroke.width_mm == 0 ? layer.pen_width_mm : stroke.width_mm;
        double best_ratio = 1e9;
        int pen = 0;
        for (const PenOfLayers& one : pens) {
          if (is_named ? std::ranges::count(one.layers, layer.name) == 0 : !one.layers.empty())
            continue;
          const double ratio = std::max(one.pen.width_mm / width, width / one.pen.width_mm);
          if (ratio >= best_ratio) continue;
          best_ratio = ratio;
          pen = one.pen.number;
        }
        by_name += is_named;
        expected.push_back(inked(pen, layer.points(stroke)));
      }
    }
    assign_pens(drawing, pens);
    REQUIRE(!drawing.layers.empty());
    CHECK(drawing.layers.back().is_pen_way);
    for (const Layer& layer : drawing.layers) {
      if (layer.is_pen_way) continue;
      REQUIRE(layer.pen);
      CHECK(!layer.strokes.empty());
      CHECK(layer.pen_width_mm == layer.pen->width_mm);
      for (const Stroke& stroke : layer.strokes) {
        CHECK(stroke.width_mm == 0);
        drawn.push_back(inked(layer.pen->number, layer.points(stroke)));
      }
    }
    std::ranges::sort(expected);
    std::ranges::sort(drawn);
    INFO("seed " << seed);
    CHECK(drawn == expected);
    // In the pen's order each pen is the one that begins nearest.
    order_for_pen(drawing, PenOrder::sorted);
    Vec2 at{0, 0};
    const auto nearest = [&](const Layer& layer) {
      double least = 1e9;
      for (const Stroke& stroke : layer.strokes)
        for (const Vec2 end : {layer.points(stroke).front(), layer.points(stroke).back()})
          least = std::min(least, std::hypot(end.x - at.x, end.y - at.y));
      return least;
    };
    for (std::size_t i = 0; i + 1 < drawing.layers.size(); ++i) {
      for (std::size_t j = i + 1; j < drawing.layers.size(); ++j)
        CHECK(nearest(drawing.layers[i]) <= nearest(drawing.layers[j]));
      at = drawing.layers[i].page_mm.back();
    }
  }
  CHECK(by_name > enough<500>);
}

TEST_CASE("a layer that no pen draws is an error, unless it is empty") {
  Drawing drawing;
  drawing.layers = {empty_layer("profiles"), empty_layer("shores")};
  add_stroke(drawing.layers[0], {{10, 10}, {20, 20}});
  const std::vector<PenOfLayers> pens{
      {Pen{.number = 1, .name = "black", .width_mm = 0.2}, {"profiles"}}};
  Drawing empty = drawing;
  CHECK_NOTHROW(assign_pens(empty, pens));
  REQUIRE(empty.layers.size() == 1);
  CHECK(empty.layers[0].name == "black");
  add_stroke(drawing.layers[1], {{10, 10}, {20, 20}});
  CHECK_THROWS_AS(assign_pens(drawing, pens), UsageError);
}

} // namespace orograph::assign_pens_test
