// SPDX-License-Identifier: GPL-3.0-or-later
// The picture lies on the page centred, inside the margins, upright and not stretched.
#include "draw/page.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace orograph;

namespace {
constexpr double kTolerance_mm = 1e-10; // 1000 ulp at page size
bool near(double a, double b) {
  return std::abs(a - b) <= kTolerance_mm;
}
} // namespace

TEST_CASE("paper sizes by name") {
  CHECK(paper_size_mm("a4") == Vec2{210, 297});
  CHECK(paper_size_mm("A4") == Vec2{210, 297});
  CHECK(paper_size_mm("Letter") == Vec2{215.9, 279.4});
  CHECK(paper_size_mm("b0") == Vec2{1000, 1414});
  CHECK_FALSE(paper_size_mm("a7"));
  CHECK_FALSE(paper_size_mm(""));
  CHECK(paper_names().size() == 17);
  for (const std::string& name : paper_names()) {
    REQUIRE(paper_size_mm(name));
    CHECK(paper_size_mm(name)->x < paper_size_mm(name)->y);
  }
}

TEST_CASE("the window is centred, as large as fits, not stretched, y up") {
  const Box2 window{{-3, 100}, {5, 102}}; // off centre, four times as wide as high
  const Placement placed = place_on_page(window, {.orientation = Orientation::portrait});
  const Vec2 low = placed.to_page(window.low), high = placed.to_page(window.high);
  CHECK(near(low.x, 10));
  CHECK(near(high.x, 200));
  CHECK(near(low.y + high.y, 297));
  CHECK(high.y < low.y); // page y goes down
  CHECK(near((low.y - high.y) / (high.x - low.x), 0.25));
  CHECK(placed.to_page.w({0, 0}) == 1);
}

TEST_CASE("orientation") {
  const Box2 wide{{0, 0}, {4, 1}}, tall{{0, 0}, {1, 4}}, square{{0, 0}, {1, 1}};
  const auto width_mm = [](const Box2& window, Orientation orientation, double w, double h) {
    return place_on_page(window, {.width_mm = w, .height_mm = h, .orientation = orientation})
        .page.width_mm;
  };
  CHECK(width_mm(wide, Orientation::by_picture, 210, 297) == 297);
  CHECK(width_mm(wide, Orientation::by_picture, 297, 210) == 297);
  CHECK(width_mm(tall, Orientation::by_picture, 297, 210) == 210);
  CHECK(width_mm(square, Orientation::by_picture, 210, 297) == 210); // as given
  CHECK(width_mm(square, Orientation::by_picture, 297, 210) == 297);
  CHECK(width_mm(wide, Orientation::portrait, 297, 210) == 210);
  CHECK(width_mm(tall, Orientation::landscape, 210, 297) == 297);
  CHECK(width_mm(wide, Orientation::as_given, 210, 297) == 210);
}

TEST_CASE("the window lies inside the margins, whatever its shape") {
  for (const double shape : {0.01, 0.3, 0.7, 1.0, 1.5, 30.0}) {
    const Box2 window{{2, 3}, {2 + shape, 4}};
    for (const double margin_mm : {0.0, 5.5, 104.0}) {
      const Placement placed = place_on_page(window, {.margin_mm = margin_mm});
      Box2 inner = placed.page.inner_mm();
      const Vec2 low = placed.to_page(window.low), high = placed.to_page(window.high);
      CHECK(low.x >= inner.low.x - kTolerance_mm);
      CHECK(high.x <= inner.high.x + kTolerance_mm);
      CHECK(high.y >= inner.low.y - kTolerance_mm);
      CHECK(low.y <= inner.high.y + kTolerance_mm);
      const double free_mm = std::min(low.x - inner.low.x, high.y - inner.low.y);
      CHECK(std::abs(free_mm) <= kTolerance_mm); // it touches two margins
    }
  }
}

TEST_CASE("a window without height is placed by its width") {
  const Placement placed = place_on_page({{0, 7}, {10, 7}}, {.orientation = Orientation::as_given});
  CHECK(near(placed.to_page({10, 7}).x, 200));
  CHECK(near(placed.to_page({10, 7}).y, 148.5));
}

TEST_CASE("impossible pages are refused") {
  const Box2 window{{0, 0}, {1, 1}};
  const auto place = [&](double width_mm, double height_mm, double margin_mm) {
    return place_on_page(window,
                         {.width_mm = width_mm, .height_mm = height_mm, .margin_mm = margin_mm});
  };
  CHECK_NOTHROW(place(210, 297, 104.5));
  CHECK_THROWS_AS(place(210, 297, 104.6), UsageError);
  CHECK_THROWS_AS(place(210, 297, 200), UsageError);
  CHECK_THROWS_AS(place(210, 297, -1), UsageError);
  CHECK_THROWS_AS(place(0, 297, 0), UsageError);
  CHECK_THROWS_AS(place(-210, 297, 0), UsageError);
  CHECK_THROWS_AS(place(NAN, 297, 10), UsageError);
  CHECK_THROWS_AS(place(210, NAN, 10), UsageError);
  CHECK_THROWS_AS(place(210, 297, NAN), UsageError);
  CHECK_THROWS_AS(place(std::numeric_limits<double>::infinity(), 297, 10), UsageError);
  CHECK_THROWS_AS(place(10001, 297, 10), UsageError);
}
