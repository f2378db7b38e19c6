// SPDX-License-Identifier: GPL-3.0-or-later
// Shaded strokes by their definition: the same ink, and each piece about as wide as light and haze
// make it there.
#include "draw/shade_strokes.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <numbers>

namespace orograph::shade_strokes_test {
namespace {

Layer layer_of(const std::vector<Vec2>& points, float depth_m) {
  Layer layer;
  layer.page_mm = points;
  layer.depths_m.assign(points.size(), depth_m);
  layer.strokes.push_back({0, static_cast<std::uint32_t>(points.size())});
  return layer;
}

// Light from the upper left; heights rise up the page.
LineShade from_the_left() {
  LineShade shade;
  shade.up = {0, -1};
  shade.towards_light = {-std::numbers::sqrt2 / 2, -std::numbers::sqrt2 / 2};
  shade.nearest_m = 100;
  shade.farthest_m = 300;
  return shade;
}

double width_of_line(Vec2 way, const LineShade& shade, float depth_m = 100) {
  const Layer out = shaded(layer_of({{50, 50}, Vec2{50, 50} + way}, depth_m), shade);
  REQUIRE(out.strokes.size() == 1);
  return out.strokes.front().width_mm;
}

// Of a straight line that makes this angle with the horizontal, rising to the right.
double width_by_formula(double angle, const LineShade& shade) {
  const double up = std::cos(angle), right = -std::sin(angle); // the upper side's normal
  const double towards_up = -shade.towards_light.y, towards_right = shade.towards_light.x;
  const double sure = std::min(1.0, up / 0.3);
  const double darker = sure * (towards_up - (up * towards_up + right * towards_right));
  return 0.15 * std::clamp(1 + 0.5 * shade.contrast * darker, 0.5, 2.0);
}

} // namespace

TEST_CASE("outlines are heavier on the side in shadow") {
  const LineShade shade = from_the_left();
  const double level = width_of_line({10, 0}, shade), rising = width_of_line({10, -10}, shade),
               falling = width_of_line({10, 10}, shade);
  CHECK(level == 0.15);
  CHECK(rising < 0.9 * level);
  CHECK(falling > 1.25 * level);
  for (double angle = -1.5; angle <= 1.5; angle += 0.01) {
    const Vec2 way{10 * std::cos(angle), -10 * std::sin(angle)};
    // Rounded to a step of a tenth; whichever way the line is drawn.
    const double expected = width_by_formula(angle, shade), width = width_of_line(way, shade);
    INFO(angle);
    CHECK(std::abs(std::log(width / expected)) < 0.5 * std::log(1.1) + 1e-9);
    CHECK(width_of_line(-1.0 * way, shade) == width);
  }
}

TEST_CASE("outlines get thinner with depth, and no contrast leaves nothing else") {
  LineShade shade = from_the_left();
  shade.contrast = 0;
  CHECK(width_of_line({10, 10}, shade) == 0.15);
  shade.haze = 0.5;
  CHECK(width_of_line({10, 10}, shade, 100) == 0.15);
  for (const float depth_m : {150.0F, 200.0F, 300.0F}) {
    const double expected = 0.15 * (1 - 0.5 * (depth_m - 100) / 200);
    CHECK(std::abs(std::log(width_of_line({10, 10}, shade, depth_m) / expected)) <
          0.5 * std::log(1.1) + 1e-6);
  }
  CHECK(width_of_line({10, 10}, shade, 50) == 0.15); // nearer than the nearest
}

TEST_CASE("shading cuts strokes where their width changes, and moves no ink") {
  std::size_t pieces = 0, strokes = 0, off = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    Layer layer;
    const int count = random.whole(1, 5);
    for (int k = 0; k < count; ++k) {
      const auto first = static_cast<std::uint32_t>(layer.page_mm.size());
      Vec2 at{random.between(20, 80), random.between(20, 80)};
      double angle = random.between(-1, 1);
      const auto points = static_cast<std::uint32_t>(random.whole(2, 60));
      for (std::uint32_t i = 0; i < points; ++i) {
        layer.page_mm.push_back(at);
        layer.depths_m.push_back(static_cast<float>(random.between(50, 350)));
        angle = std::clamp(angle + random.between(-0.5, 0.5), -1.4, 1.4);
        at = at + random.between(0.05, 2) * Vec2{std::cos(angle), -std::sin(angle)};
      }
      layer.strokes.push_back({first, points});
    }
    const LineShade shade = from_the_left();
    const Layer out = shaded(layer, shade);
    INFO("seed " << seed);
    // One after another, the pieces are the strokes.
    std::size_t piece = 0;
    for (const Stroke& stroke : layer.strokes) {
      ++strokes;
      const auto whole = layer.points(stroke);
      std::size_t at = 0;
      double last_width = 0;
      while (at + 1 < whole.size()) {
        REQUIRE(piece < out.strokes.size());
        const Stroke& part = out.strokes[piece++];
        ++pieces;
        const auto points = out.points(part);
        REQUIRE(points.size() >= 2);
        double way_mm = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
          REQUIRE(points[i] == whole[at + i]);
          if (i > 0) way_mm += plain_length(points[i] - points[i - 1]);
        }
        const bool is_whole = points.size() == whole.size();
        CHECK((is_whole || way_mm >= 1 - 1e-9));
        CHECK(part.width_mm != last_width);
        CHECK(part.width_mm >= 0.15 * 0.5 / 1.05);
        CHECK(part.width_mm <= 0.15 * 2 * 1.05);
        last_width = part.width_mm;
        at += points.size() - 1;
      }
    }
    CHECK(piece == out.strokes.size());
    CHECK(out.depths_m.empty());
    off += out.strokes.size() > layer.strokes.size() ? 1 : 0;
  }
  CHECK(pieces > 2 * strokes);
  CHECK(off > last_seed(500) / 2);
}

} // namespace orograph::shade_strokes_test
