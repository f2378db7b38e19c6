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
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
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
      at = drawing.layers[i].points(drawing.layers[i].strokes.back()).back();
    }
  }
  CHECK(by_name > enough(500));
}

namespace {

// Layers of which two have features: some with a class, as text, a number or none.
Drawing random_features(Random& random) {
  Drawing drawing = random_drawing(random);
  for (std::size_t l : {0, 2}) {
    Layer& layer = drawing.layers[l];
    layer.fields = {"CLASS", "width"};
    for (Stroke& stroke : layer.strokes) {
      if (random.chance(0.2)) continue;
      stroke.feature = static_cast<std::int32_t>(layer.features.size());
      Attributes& feature = layer.features.emplace_back();
      if (random.chance(0.8))
        feature.push_back({"CLASS", random.pick<std::string>({"river", "River", "road"})});
      if (random.chance(0.5)) feature.push_back({"width", std::int64_t{random.whole(1, 3)}});
      if (random.chance(0.3)) feature.push_back({"depth", 0.5 * random.whole(1, 4)});
    }
  }
  return drawing;
}

std::vector<PenOfLayers> random_pens_of_fields(Random& random) {
  std::vector<PenOfLayers> pens = random_pens(random);
  const int count = random.whole(1, 3);
  for (int i = 0; i < count; ++i) {
    PenOfLayers one{Pen{.number = 20 + i, .width_mm = 0.05 * random.whole(1, 10)}};
    if (random.chance(0.5)) one.layers = {kLayers[static_cast<std::size_t>(random.whole(0, 2))]};
    one.field = random.pick<std::string>({"class", "Width"});
    one.values = one.field == "class" ? std::vector<std::string>{"river", "road"}
                                      : std::vector<std::string>{"2"};
    if (random.chance(0.3)) one.values.pop_back();
    if (one.values.empty()) one.values = {"1", "3"};
    pens.insert(pens.begin() + random.whole(0, static_cast<int>(pens.size())), one);
  }
  return pens;
}

// By the words of the definition.
bool is_of(const PenOfLayers& one, const Layer& layer, const Stroke& stroke) {
  if (!one.layers.empty() && std::ranges::count(one.layers, layer.name) == 0) return false;
  if (stroke.feature < 0) return false;
  for (const auto& [name, value] : layer.features[static_cast<std::size_t>(stroke.feature)]) {
    if (name == "depth") continue;
    const std::string text = std::holds_alternative<std::string>(value)
                                 ? std::get<std::string>(value)
                                 : std::to_string(std::get<std::int64_t>(value));
    const bool is_field =
        (name == "CLASS" && one.field == "class") || (name == "width" && one.field == "Width");
    if (is_field && std::ranges::count(one.values, text) > 0) return true;
  }
  return false;
}

} // namespace

TEST_CASE("a stroke goes to a pen of its feature's field before one of its layer or of the rest") {
  int by_field = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    Drawing drawing = random_features(random);
    const std::vector<PenOfLayers> pens = random_pens_of_fields(random);
    std::vector<Inked> expected, drawn;
    for (const Layer& layer : drawing.layers)
      for (const Stroke& stroke : layer.strokes) {
        const double width = stroke.width_mm == 0 ? layer.pen_width_mm : stroke.width_mm;
        // How specific a pen is for the stroke; the most specific ones compete in width.
        const auto rank = [&](const PenOfLayers& one) {
          if (!one.field.empty()) return is_of(one, layer, stroke) ? 3 : 0;
          if (one.layers.empty()) return 1;
          return std::ranges::count(one.layers, layer.name) > 0 ? 2 : 0;
        };
        int best_rank = 0, pen = 0;
        double best_ratio = 1e9;
        for (const PenOfLayers& one : pens) {
          const double ratio = std::max(one.pen.width_mm / width, width / one.pen.width_mm);
          const bool is_better =
              rank(one) > best_rank || (rank(one) == best_rank && ratio < best_ratio);
          if (rank(one) == 0 || !is_better) continue;
          best_rank = rank(one);
          best_ratio = ratio;
          pen = one.pen.number;
        }
        by_field += best_rank == 3;
        expected.push_back(inked(pen, layer.points(stroke)));
      }
    assign_pens(drawing, pens);
    for (const Layer& layer : drawing.layers)
      for (const Stroke& stroke : layer.strokes)
        if (!layer.is_pen_way) drawn.push_back(inked(layer.pen->number, layer.points(stroke)));
    std::ranges::sort(expected);
    std::ranges::sort(drawn);
    INFO("seed " << seed);
    CHECK(drawn == expected);
  }
  CHECK(by_field > enough(500));
}

TEST_CASE("strokes without a pen stay in their layers beneath, where they may") {
  Drawing drawing;
  drawing.layers = {empty_layer("profiles", 0.3), empty_layer("drape", 0.4),
                    empty_layer("skyline", 0.5)};
  for (Layer& layer : drawing.layers) {
    add_stroke(layer, {{10, 10}, {20, 20}});
    add_stroke(layer, {{30, 10}, {40, 20}});
    layer.strokes[1].width_mm = 0.12;
  }
  Layer& drape = drawing.layers[1];
  drape.colour = Colour{1, 2, 3};
  drape.features = {{{"class", std::string("river")}}, {{"class", std::string("road")}}};
  drape.strokes[0].feature = 0;
  drape.strokes[1].feature = 1;
  const std::vector<PenOfLayers> pens{
      {.pen = {.number = 1, .name = "blue", .width_mm = 0.2},
       .field = "class",
       .values = {"river"}},
      {.pen = {.number = 2, .name = "black", .width_mm = 0.2}, .layers = {"profiles"}}};
  Drawing refused = drawing;
  CHECK_THROWS_AS(assign_pens(refused, pens), UsageError);
  assign_pens(drawing, pens, WithoutPen::kept);
  std::vector<std::string> names;
  for (const Layer& layer : drawing.layers) names.push_back(layer.name);
  REQUIRE(names == std::vector<std::string>{"drape", "skyline", "blue", "black"});
  REQUIRE(drawing.layers[0].strokes.size() == 1);
  CHECK(drawing.layers[0].points(drawing.layers[0].strokes[0])[0] == Vec2{30, 10});
  CHECK(drawing.layers[0].strokes[0].width_mm == 0.12);
  CHECK(drawing.layers[0].ink() == Colour{1, 2, 3});
  CHECK(drawing.layers[1].strokes.size() == 2);
  CHECK(drawing.layers[2].strokes.size() == 1);
  CHECK(drawing.layers[3].strokes.size() == 2);
}

TEST_CASE("a pen with dashes draws real ones, along lines that touch as along one") {
  Drawing drawing;
  drawing.layers = {empty_layer("drape"), empty_layer("profiles")};
  Layer& drape = drawing.layers[0];
  drape.features = {{{"class", std::string("path")}}};
  // One line of 100 mm in three pieces, of which light changed the width, and the second is turned.
  add_stroke(drape, {{10, 50}, {33.3, 50}});
  add_stroke(drape, {{61.7, 50}, {33.3, 50}});
  add_stroke(drape, {{61.7, 50}, {110, 50}});
  for (std::size_t i = 0; i < 3; ++i) {
    drape.strokes[i].feature = 0;
    drape.strokes[i].width_mm = 0.1 + 0.01 * static_cast<double>(i);
  }
  add_stroke(drawing.layers[1], {{10, 80}, {110, 80}});
  const std::vector<PenOfLayers> pens{{.pen = {.number = 1, .width_mm = 0.2},
                                       .field = "class",
                                       .values = {"path"},
                                       .dash = Dash{2, 1}},
                                      {.pen = {.number = 2, .width_mm = 0.2}}};
  assign_pens(drawing, pens);
  REQUIRE(drawing.layers.size() == 2);
  CHECK(drawing.layers[1].strokes.size() == 1);
  // 34 dashes and 33 gaps of 2 and 1 mm are 101 mm long: all of them are stretched to 100.
  const Layer& dashes = drawing.layers[0];
  REQUIRE(dashes.strokes.size() == 34);
  std::vector<std::pair<double, double>> spans;
  for (const Stroke& stroke : dashes.strokes) {
    const auto points = dashes.points(stroke);
    for (const Vec2 p : points) CHECK(p.y == 50);
    spans.push_back(std::minmax(points.front().x, points.back().x));
  }
  std::ranges::sort(spans);
  constexpr double kStretch = 100.0 / 101;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const double begin = 10 + kStretch * 3 * static_cast<double>(i);
    CHECK(std::abs(spans[i].first - begin) <= kPageStep_mm);
    CHECK(std::abs(spans[i].second - begin - kStretch * 2) <= kPageStep_mm);
  }
  CHECK(find_fault(drawing) == std::nullopt);
}

TEST_CASE("a pen's field that lines haven't is told with those that they have") {
  Drawing drawing;
  drawing.layers = {empty_layer("drape"), empty_layer("profiles")};
  add_stroke(drawing.layers[0], {{10, 10}, {20, 20}});
  drawing.layers[0].features = {{{"name", std::string("a")}}};
  drawing.layers[0].strokes[0].feature = 0;
  drawing.layers[0].fields = {"class", "name"}; // without a value here
  const auto message = [&](const PenOfLayers& one) {
    Drawing copy = drawing;
    const std::vector<PenOfLayers> pens{one, {.pen = {.number = 9, .width_mm = 0.2}}};
    try {
      assign_pens(copy, pens);
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  PenOfLayers one{.pen = {.number = 1, .width_mm = 0.2},
                  .field = "klass",
                  .values = {"river"},
                  .place = "pens.toml, line 3"};
  CHECK(message(one) == "pens.toml, line 3: no line has a field 'klass': there are class, name");
  one.layers = {"drape"};
  CHECK(message(one) == "pens.toml, line 3: no line has a field 'klass': there are class, name");
  one.layers = {"profiles"}; // that have no features in this drawing
  CHECK(message(one) == "accepted");
  one = {.pen = {.number = 1, .width_mm = 0.2}, .field = "Class", .values = {"river"}};
  CHECK(message(one) == "accepted");

  const std::vector<PenOfLayers> fields_alone{
      {.pen = {.number = 1, .width_mm = 0.2}, .field = "name", .values = {"b"}},
      {.pen = {.number = 2, .width_mm = 0.2}, .layers = {"profiles"}}};
  try {
    assign_pens(drawing, fields_alone);
    FAIL();
  } catch (const UsageError& error) {
    CHECK(std::string(error.what()) ==
          "no pen draws all of the layer 'drape': name it in a pen's layers, without a field, or "
          "give a pen without layers for all others");
  }
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
