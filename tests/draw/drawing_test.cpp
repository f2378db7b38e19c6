// SPDX-License-Identifier: GPL-3.0-or-later
// The checker sees each fault, and none in a sound drawing.
#include "draw/drawing.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"

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
