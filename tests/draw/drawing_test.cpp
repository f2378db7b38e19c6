// SPDX-License-Identifier: GPL-3.0-or-later
// The checker sees each fault, and none in a sound drawing; dashes; the way of a pen.
#include "draw/drawing.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>

using namespace orograph;

namespace {

Drawing drawing_of(std::initializer_list<Vec2> page_mm) {
  Drawing drawing;
  drawing.layers.push_back(empty_layer("profiles"));
  add_stroke(drawing.layers[0], page_mm);
  return drawing;
}

std::string fault_of(const Drawing& drawing) {
  return find_fault(drawing).value_or("none");
}

} // namespace

TEST_CASE("a sound drawing has no fault") {
  CHECK(fault_of(made_drawing()) == "none");
  CHECK(fault_of(Drawing{}) == "none");
  CHECK(fault_of(drawing_of({{10, 10}, {200, 287}})) == "none");
  // there and back again is one stroke with a length
  CHECK(fault_of(drawing_of({{10, 10}, {20, 10}, {10, 10}})) == "none");
}

TEST_CASE("the checker names the fault of a point") {
  CHECK(fault_of(drawing_of({{20, 20}, {NAN, 20}})) ==
        "layer profiles: stroke 0 point 1 is not finite");
  CHECK(fault_of(drawing_of({{20, INFINITY}, {30, 20}})) ==
        "layer profiles: stroke 0 point 0 is not finite");
  CHECK(fault_of(drawing_of({{20.00005, 20}, {30, 20}})) ==
        "layer profiles: stroke 0 point 0 (20.00005, 20) is not on the step of 0.0001 mm");
  const double beside = std::nextafter(20.1, 21);
  CHECK(fault_of(drawing_of({{beside, 20}, {30, 20}})).find("not on the step") !=
        std::string::npos);
  for (const Vec2 outside : {Vec2{9.9, 20}, {200.1, 20}, {20, 9.9}, {20, 287.1}})
    CHECK(fault_of(drawing_of({{20, 20}, outside})).find("outside the margins") !=
          std::string::npos);
}

TEST_CASE("a margin off the step may be rounded across") {
  Drawing drawing = drawing_of({{10.0001, 20}, {20, 20}});
  drawing.page.margin_mm = 10.00015;
  CHECK(fault_of(drawing) == "none");
  drawing.page.margin_mm = 10.0003;
  CHECK(fault_of(drawing).find("outside the margins") != std::string::npos);
}

TEST_CASE("the checker names the fault of a stroke") {
  CHECK(fault_of(drawing_of({{20, 20}})) == "layer profiles: stroke 0 has fewer than two points");
  CHECK(fault_of(drawing_of({{20, 20}, {20, 20}})) == "layer profiles: stroke 0 has no length");

  Drawing past = drawing_of({{20, 20}, {30, 20}});
  past.layers[0].strokes[0].point_count = 3;
  CHECK(fault_of(past) == "layer profiles: stroke 0 runs past the points of its layer");
  past.layers[0].strokes[0] = {.first_point = 4000000000U, .point_count = 2};
  CHECK(fault_of(past) == "layer profiles: stroke 0 runs past the points of its layer");
}

TEST_CASE("the checker finds repeated strokes in one layer only") {
  Drawing drawing = drawing_of({{20, 20}, {30, 20}, {30, 40}});
  Layer& layer = drawing.layers[0];
  add_stroke(layer, {{20, 20}, {30, 20}});
  add_stroke(layer, {{30, 20}, {20, 20}, {30, 40}});
  CHECK(fault_of(drawing) == "none");
  SECTION("the same points") {
    add_stroke(layer, {{20, 20}, {30, 20}, {30, 40}});
    CHECK(fault_of(drawing) == "layer profiles: stroke 3 repeats an earlier one");
  }
  SECTION("reversed") {
    add_stroke(layer, {{30, 40}, {30, 20}, {20, 20}});
    CHECK(fault_of(drawing) == "layer profiles: stroke 3 repeats an earlier one");
  }
  SECTION("in another layer") {
    drawing.layers.push_back(layer);
    CHECK(fault_of(drawing) == "none");
  }
}

TEST_CASE("the checker looks at map points") {
  Drawing drawing = made_drawing();
  SECTION("one too few") {
    drawing.layers[1].map.pop_back();
    CHECK(fault_of(drawing) == "layer profiles: has map points that don't match its page points");
  }
  SECTION("one not finite") {
    drawing.layers[1].map[7].z = NAN;
    CHECK(fault_of(drawing) == "layer profiles: map point 7 is not finite");
  }
}

namespace {

double length_mm(std::span<const Vec2> points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += length(points[i] - points[i - 1]);
  return sum;
}

Layer one_stroke(const std::vector<Vec2>& points) {
  Layer layer;
  layer.name = "hidden";
  layer.page_mm = points;
  layer.strokes.push_back({0, static_cast<std::uint32_t>(points.size())});
  return layer;
}

} // namespace

TEST_CASE("dashes begin and end with the stroke, and are alike") {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    std::vector<Vec2> points{{0, 0}};
    for (int i = random.whole(1, 8); i > 0; --i)
      points.push_back(points.back() + Vec2{random.between(-5, 5), random.between(-5, 5)});
    const Layer whole = one_stroke(points);
    const double dash_mm = random.between(0.3, 2), gap_mm = random.between(0.2, 1);
    const Layer cut = dashed(whole, dash_mm, gap_mm);
    CAPTURE(seed);
    CHECK(cut.name == "hidden");
    REQUIRE(!cut.strokes.empty());
    const double all_mm = length_mm(whole.page_mm),
                 first_mm = length_mm(cut.points(cut.strokes[0]));
    const auto front = cut.points(cut.strokes.front()), back = cut.points(cut.strokes.back());
    CHECK(length(front.front() - points.front()) < 1e-12);
    CHECK(length(back.back() - points.back()) < 1e-12);
    double ink_mm = 0;
    for (const Stroke& stroke : cut.strokes) {
      ink_mm += length_mm(cut.points(stroke));
      CHECK(std::abs(length_mm(cut.points(stroke)) - first_mm) < 1e-9);
    }
    const auto count = static_cast<double>(cut.strokes.size());
    if (count > 1) {
      // Stretched by less than one more dash would have made it.
      CHECK(first_mm > dash_mm * 0.6);
      CHECK(first_mm < dash_mm * 1.5);
      CHECK(std::abs((all_mm - ink_mm) / (count - 1) / gap_mm - first_mm / dash_mm) < 1e-9);
    } else {
      CHECK(std::abs(ink_mm - all_mm) < 1e-12);
    }
  }
}

TEST_CASE("a dash goes round a corner, and other strokes stay apart") {
  Layer layer = one_stroke({{0, 0}, {1, 0}, {1, 1}});
  layer.page_mm.insert(layer.page_mm.end(), {{5, 5}, {5.1, 5}});
  layer.strokes.push_back({3, 2});
  const Layer cut = dashed(layer, 1.5, 0.5);
  REQUIRE(cut.strokes.size() == 2);
  CHECK(cut.points(cut.strokes[0]).size() == 3);
  CHECK(cut.points(cut.strokes[1]).front() == Vec2{5, 5});
  CHECK(cut.points(cut.strokes[1]).back() == Vec2{5.1, 5});
}

TEST_CASE("pen travel is counted from the upper left corner, over all layers") {
  Drawing drawing;
  drawing.layers.resize(2);
  add_stroke(drawing.layers[0], {{30, 40}, {30, 50}, {40, 50}}); // 50 up, 20 down
  add_stroke(drawing.layers[0], {{43, 54}, {43, 55}});           // 5 up, 1 down
  add_stroke(drawing.layers[1], {{43, 55}, {43, 58}});           // 0 up, 3 down
  const PenTravel travel = pen_travels(drawing).all;
  CHECK(travel.up_mm == 55);
  CHECK(travel.down_mm == 24);
  CHECK(travel.lifts == 2);
  CHECK(pen_minutes(travel, {.down_mm_s = 4, .up_mm_s = 11, .lift_s = 0.5}) == 12.0 / 60);
  const std::vector<PenTravel> by_layer = pen_travels(drawing).by_layer;
  REQUIRE(by_layer.size() == 2);
  CHECK(by_layer[0].up_mm == 55);
  CHECK(by_layer[0].down_mm == 21);
  CHECK(by_layer[1].up_mm == 0);
  CHECK(by_layer[1].down_mm == 3);
}

TEST_CASE("pen travel over many strokes is that of one after another") {
  Random random(1);
  Drawing drawing;
  drawing.layers.resize(3);
  double up_mm = 0, down_mm = 0;
  std::size_t lifts = 0;
  Vec2 pen{0, 0};
  for (Layer& layer : drawing.layers)
    for (int i = 0; i < 2500; ++i) {
      const Vec2 from =
          random.chance(0.3) ? pen : Vec2{random.between(0, 300), random.between(0, 200)};
      const Vec2 to{random.between(0, 300), random.between(0, 200)};
      add_stroke(layer, {from, to});
      up_mm += std::hypot(from.x - pen.x, from.y - pen.y);
      down_mm += std::hypot(to.x - from.x, to.y - from.y);
      lifts += from != pen ? 1 : 0;
      pen = to;
    }
  const PenTravel travel = pen_travels(drawing).all;
  CHECK(std::abs(travel.up_mm - up_mm) < 1e-6);
  CHECK(std::abs(travel.down_mm - down_mm) < 1e-6);
  CHECK(travel.lifts == lifts);
}

TEST_CASE("a pen's way is shown from stroke to stroke, and is no ink") {
  Drawing drawing;
  drawing.layers.resize(3);
  drawing.layers[1].is_pen_way = true;
  add_stroke(drawing.layers[0], {{30, 40}, {30, 50}, {40, 50}});
  add_stroke(drawing.layers[0], {{40, 50}, {60, 50}}); // begins where the pen is
  add_stroke(drawing.layers[0], {{30, 40}, {40, 40}});
  add_stroke(drawing.layers[2], {{60, 50}, {70, 50}});
  add_stroke(drawing.layers[2], {{30, 40}, {20, 40}}); // and a way that repeats one, or nearly
  const PenTravel before = pen_travels(drawing).all;
  show_pen_way(drawing);
  const Layer& way = drawing.layers[1];
  CHECK((way.page_mm ==
         std::vector<Vec2>{
             {0, 0}, {30, 40}, {60, 50}, {30, 40}, {40, 40}, {60, 50}, {70, 50}, {30, 40}}));
  double shown_mm = 0;
  for (const Stroke& stroke : way.strokes) shown_mm += line_length_mm(way.points(stroke));
  CHECK(std::abs(shown_mm - before.up_mm) < 1e-9);
  CHECK(way.strokes.size() == before.lifts);
  CHECK(pen_travels(drawing).all.up_mm == before.up_mm);
  CHECK(pen_travels(drawing).all.down_mm == before.down_mm);
  CHECK(find_fault(drawing) == std::nullopt);
  show_pen_way(drawing);
  CHECK(way.strokes.size() == before.lifts);
}

TEST_CASE("a pen with nothing to draw stays") {
  CHECK(pen_travels({}).all.up_mm == 0);
  CHECK(pen_travels({}).all.down_mm == 0);
}
