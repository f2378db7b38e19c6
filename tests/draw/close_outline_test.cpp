// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/close_outline.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <map>
#include <set>

namespace orograph::close_outline_test {
namespace {

void add(Layer& layer, const std::vector<Vec2>& points) {
  layer.strokes.push_back({static_cast<std::uint32_t>(layer.page_mm.size()),
                           static_cast<std::uint32_t>(points.size())});
  layer.page_mm.insert(layer.page_mm.end(), points.begin(), points.end());
  for (const Vec2& p : points) layer.depths_m.push_back(static_cast<float>(p.x));
}

std::multiset<std::vector<double>> strokes_of(const Layer& layer) {
  std::multiset<std::vector<double>> out;
  for (const Stroke& stroke : layer.strokes) {
    std::vector<double> numbers;
    for (const Vec2& p : layer.points(stroke)) numbers.insert(numbers.end(), {p.x, p.y});
    out.insert(numbers);
  }
  return out;
}

} // namespace

TEST_CASE("what leads from one end of the outline to another, and isn't long, is moved") {
  std::size_t moved_count = 0, kept_count = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    // Ends lie on a small lattice, so that they meet often.
    const auto place = [&] { return Vec2{1.0 * random.whole(0, 2), 1.0 * random.whole(0, 1)}; };
    Layer outline, other;
    for (int i = random.whole(1, 5); i > 0; --i) add(outline, {place(), {9, 9}, place()});
    for (int i = random.whole(1, 12); i > 0; --i) {
      std::vector<Vec2> points{place()};
      if (random.chance(0.5)) points.push_back({2.5, 7});
      points.push_back(place());
      if (random.chance(0.2)) points.back().x += 0.01; // hardly meets
      add(other, points);
    }
    const double longest_mm = random.between(1, 12);
    auto outline_expected = strokes_of(outline);
    std::multiset<std::vector<double>> other_expected;
    for (const auto& numbers : strokes_of(other)) {
      const std::size_t n = numbers.size();
      double mm = 0;
      for (std::size_t i = 2; i < n; i += 2)
        mm += std::hypot(numbers[i] - numbers[i - 2], numbers[i + 1] - numbers[i - 1]);
      const auto is_end = [&](double x, double y) {
        bool found = false;
        for (const Stroke& stroke : outline.strokes)
          for (const Vec2& end : {outline.points(stroke).front(), outline.points(stroke).back()})
            found |= end.x == x && end.y == y;
        return found;
      };
      const bool moves = mm <= longest_mm && is_end(numbers[0], numbers[1]) &&
                         is_end(numbers[n - 2], numbers[n - 1]);
      (moves ? outline_expected : other_expected).insert(numbers);
      ++(moves ? moved_count : kept_count);
    }
    close_outline(outline, other, longest_mm);
    INFO("seed " << seed);
    CHECK(strokes_of(outline) == outline_expected);
    CHECK(strokes_of(other) == other_expected);
    for (const Layer* layer : {&outline, &other}) {
      REQUIRE(layer->depths_m.size() == layer->page_mm.size());
      for (std::size_t i = 0; i < layer->page_mm.size(); ++i)
        CHECK(layer->depths_m[i] == static_cast<float>(layer->page_mm[i].x));
    }
  }
  CHECK(moved_count > last_seed(1000) / 2);
  CHECK(kept_count > last_seed(1000));
}

} // namespace orograph::close_outline_test
