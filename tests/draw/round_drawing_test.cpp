// SPDX-License-Identifier: GPL-3.0-or-later
// Rounding gives the decimals that are printed, and leaves no empty or repeated stroke.
#include "draw/round_drawing.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <set>

using namespace orograph;

TEST_CASE("a rounded number is the double that its decimals read as") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> page(-1500, 1500);
  int inexact = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = page(random);
    const double rounded = rounded_to_page_step(x);
    char text[32];
    std::snprintf(text, sizeof text, "%.4f", rounded);
    inexact += std::strtod(text, nullptr) != rounded;
    inexact += rounded_to_page_step(rounded) != rounded;
    // half a step, and the rounding of x * 1e4 at 1500 mm
    inexact += std::abs(rounded - x) > 0.5 * kPageStep_mm + 1e-12;
  }
  CHECK(inexact == 0);
}

TEST_CASE("there is no minus zero") {
  CHECK_FALSE(std::signbit(rounded_to_page_step(-0.00001)));
  CHECK_FALSE(std::signbit(rounded_to_page_step(-0.0)));
}

TEST_CASE("equal neighbours go") {
  Layer layer;
  add_stroke(layer, {{1, 1}, {1.00001, 1}, {2, 1}, {2, 1.00002}, {3, 1}, {3.00003, 1}}, 5);
  const RoundingCounts dropped = round_to_page_step(layer);
  CHECK(layer.page_mm == std::vector<Vec2>{{1, 1}, {2, 1}, {3, 1}});
  REQUIRE(layer.strokes.size() == 1);
  CHECK(layer.strokes[0].point_count == 3);
  CHECK(layer.strokes[0].profile == 5);
  CHECK(dropped.points == 3);
  CHECK(dropped.empty_strokes == 0);
}

TEST_CASE("places on the map stay, however near on the page") {
  Layer layer;
  add_stroke(layer, {{1, 1}, {1.00001, 1}, {1.00001, 1}, {2, 1}, {2, 1.00002}}, 5);
  add_stroke(layer, {{4, 4}, {4.00001, 4}}, 6); // without length on the page
  layer.map = {{0, 0, 0}, {9, 0, 0}, {9, 0, 0}, {9, 9, 0}, {9, 9, 7}, {1, 1, 1}, {2, 2, 2}};
  const RoundingCounts dropped = round_to_page_step(layer);
  CHECK(layer.page_mm == std::vector<Vec2>{{1, 1}, {1, 1}, {2, 1}, {2, 1}});
  CHECK(layer.map == std::vector<Vec3>{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {9, 9, 7}});
  REQUIRE(layer.strokes.size() == 1);
  CHECK(layer.strokes[0].point_count == 4);
  CHECK(dropped.points == 3);
  CHECK(dropped.empty_strokes == 1);
}

TEST_CASE("strokes that become empty or equal go, the others keep their order") {
  Layer layer;
  add_stroke(layer, {{1, 1}, {2, 2}, {3, 1}}, 0);
  add_stroke(layer, {{1, 1}, {1.00004, 0.99996}}, 1);         // empty
  add_stroke(layer, {{3.00001, 1}, {2, 2.00001}, {1, 1}}, 2); // the first, reversed
  add_stroke(layer, {{4, 4}, {5, 5}}, 3);                     //
  add_stroke(layer, {{4, 4}, {4.00001, 4}, {5, 5}}, 4);       // equal to 3
  add_stroke(layer, {{1, 1}, {2, 2}}, 5);                     // a part of the first
  add_stroke(layer, {{7, 7}}, 6);                             // a point
  add_stroke(layer, {{1, 1}, {3, 1}, {2, 2}}, 7);             // the first in another order
  const RoundingCounts dropped = round_to_page_step(layer);
  std::vector<int> profiles;
  for (const Stroke& stroke : layer.strokes) profiles.push_back(stroke.profile);
  CHECK(profiles == std::vector<int>{0, 3, 5, 7});
  CHECK(dropped.empty_strokes == 2);
  CHECK(dropped.repeated_strokes == 2);
  CHECK(layer.page_mm ==
        std::vector<Vec2>{
            {1, 1}, {2, 2}, {3, 1}, {4, 4}, {5, 5}, {1, 1}, {2, 2}, {1, 1}, {3, 1}, {2, 2}});
  CHECK(dropped.points == 19 - 10);
}

TEST_CASE("what is left has no fault, and rounding again changes nothing") {
  // Points on so coarse a lattice that many strokes are empty or equal.
  std::mt19937 random(3);
  std::uniform_int_distribution<int> lattice(0, 2), count(1, 4);
  Drawing drawing;
  drawing.layers.resize(1);
  Layer& layer = drawing.layers[0];
  for (int s = 0; s < 3000; ++s) {
    Stroke stroke{.first_point = static_cast<std::uint32_t>(layer.page_mm.size())};
    stroke.point_count = static_cast<std::uint32_t>(count(random));
    for (std::uint32_t i = 0; i < stroke.point_count; ++i)
      layer.page_mm.push_back({20 + 0.00011 * lattice(random), 20 + 0.00011 * lattice(random)});
    layer.strokes.push_back(stroke);
  }
  const RoundingCounts dropped = round_to_page_step(layer);
  CHECK(dropped.empty_strokes > 0);
  CHECK(dropped.repeated_strokes > 0);
  CHECK(dropped.empty_strokes + dropped.repeated_strokes + layer.strokes.size() == 3000);
  CHECK(find_fault(drawing).value_or("none") == "none");

  const std::vector<Vec2> before = layer.page_mm;
  const RoundingCounts again = round_to_page_step(layer);
  CHECK(again.points + again.empty_strokes + again.repeated_strokes == 0);
  CHECK(layer.page_mm == before);
}

TEST_CASE("strokes whose points lie in another order are rounded as if they lay in theirs") {
  std::mt19937 random(4);
  std::uniform_int_distribution<int> lattice(0, 2), count(1, 4);
  Layer scattered;
  for (int s = 0; s < 1000; ++s) {
    const Stroke stroke{.first_point = static_cast<std::uint32_t>(scattered.page_mm.size()),
                        .point_count = static_cast<std::uint32_t>(count(random))};
    for (std::uint32_t i = 0; i < stroke.point_count; ++i) {
      scattered.page_mm.push_back({20 + 0.00011 * lattice(random), 20 + 0.00011 * lattice(random)});
      scattered.map.push_back({1.0 * lattice(random), 0, 1.0 * s});
    }
    scattered.strokes.push_back(stroke);
  }
  std::shuffle(scattered.strokes.begin(), scattered.strokes.end(), random);
  Layer gathered;
  for (Stroke stroke : scattered.strokes) {
    const auto points = scattered.points(stroke);
    const auto map = scattered.map.begin() + stroke.first_point;
    stroke.first_point = static_cast<std::uint32_t>(gathered.page_mm.size());
    gathered.page_mm.insert(gathered.page_mm.end(), points.begin(), points.end());
    gathered.map.insert(gathered.map.end(), map, map + stroke.point_count);
    gathered.strokes.push_back(stroke);
  }
  const RoundingCounts of_scattered = round_to_page_step(scattered),
                       of_gathered = round_to_page_step(gathered);
  CHECK(of_scattered.points == of_gathered.points);
  CHECK(of_scattered.points > 0);
  CHECK(scattered.page_mm == gathered.page_mm);
  CHECK((scattered.map == gathered.map));
  REQUIRE(scattered.strokes.size() == gathered.strokes.size());
  for (std::size_t i = 0; i < scattered.strokes.size(); ++i)
    CHECK(scattered.strokes[i].first_point == gathered.strokes[i].first_point);
}

TEST_CASE("repeated strokes are found in a layer of any size, in either direction") {
  for (const std::uint32_t count : {0U, 1U, 3000U, 300000U}) { // the last in several shares
    INFO(count << " strokes");
    std::mt19937 random(count);
    // A third as many places as strokes, so that most are drawn several times.
    std::uniform_int_distribution<std::uint32_t> place(0, count / 3);
    Layer layer;
    std::set<std::uint32_t> seen;
    std::vector<std::uint32_t> expected;
    for (std::uint32_t s = 0; s < count; ++s) {
      const std::uint32_t number = place(random);
      const Vec2 from{1e-4 * number, 1}, to{2, 1e-4 * number};
      const bool turned = (random() & 1U) != 0;
      layer.strokes.push_back({.first_point = 2 * s, .point_count = 2});
      layer.page_mm.push_back(turned ? to : from);
      layer.page_mm.push_back(turned ? from : to);
      if (!seen.insert(number).second) expected.push_back(s);
    }
    CHECK(repeated_strokes(layer) == expected);
  }
}

TEST_CASE("on the ground strokes of two features may be at one place, on paper they are one") {
  Layer paper;
  paper.features = {{{"class", "river"}}, {{"class", "border"}}};
  for (const std::int32_t feature : {0, 1, 0, 1, -1}) {
    paper.strokes.push_back({.first_point = static_cast<std::uint32_t>(paper.page_mm.size()),
                             .point_count = 2,
                             .feature = feature});
    paper.page_mm.insert(paper.page_mm.end(), {{1, 1}, {2, 2}});
  }
  Layer ground = paper;
  ground.map.resize(ground.page_mm.size());
  CHECK(repeated_strokes(paper) == std::vector<std::uint32_t>{1, 2, 3, 4});
  CHECK(repeated_strokes(ground) == std::vector<std::uint32_t>{2, 3});
}
