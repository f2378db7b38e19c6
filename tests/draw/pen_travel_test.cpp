// SPDX-License-Identifier: GPL-3.0-or-later
// The lengths that a plotter's pen goes.
#include "draw/pen_travel.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"

using namespace orograph;

TEST_CASE("pen travel is counted from the upper left corner, over all layers") {
  Drawing drawing;
  drawing.layers.resize(2);
  add_stroke(drawing.layers[0], {{30, 40}, {30, 50}, {40, 50}}); // 50 up, 20 down
  add_stroke(drawing.layers[0], {{43, 54}, {43, 55}});           // 5 up, 1 down
  add_stroke(drawing.layers[1], {{43, 55}, {43, 58}});           // 0 up, 3 down
  const PenTravel travel = pen_travel(drawing);
  CHECK(travel.up_mm == 55);
  CHECK(travel.down_mm == 24);
}

TEST_CASE("a pen with nothing to draw stays") {
  CHECK(pen_travel({}).up_mm == 0);
  CHECK(pen_travel({}).down_mm == 0);
}
