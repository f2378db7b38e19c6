// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/dash.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>

using namespace orograph;

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
