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

TEST_CASE("a page without a height is as high as its picture, with its margins") {
  for (const double shape : {0.05, 0.7, 1.0, 3.0, 30.0}) { // height over width
    const Box2 window{{-3, 5}, {7, 5 + 10 * shape}};
    for (const double margin_mm : {0.0, 12.5}) {
      const Placement placed = place_on_page(window, {.width_mm = 300,
                                                      .height_mm = std::nullopt,
                                                      .orientation = Orientation::as_given,
                                                      .margin_mm = margin_mm});
      CHECK(placed.page.width_mm == 300);
      const double inner_mm = 300 - 2 * margin_mm;
      CHECK(near(placed.page.height_mm, inner_mm * shape + 2 * margin_mm));
      CHECK(near(placed.to_page(window.low).x, margin_mm));
      CHECK(near(placed.to_page(window.high).x, 300 - margin_mm));
      CHECK(near(placed.to_page(window.high).y, margin_mm));
      CHECK(near(placed.to_page(window.low).y, placed.page.height_mm - margin_mm));
    }
  }
  const auto high = [](double shape) {
    return place_on_page({{0, 0}, {1, shape}}, {.width_mm = 200, .height_mm = std::nullopt});
  };
  CHECK(near(high(55).page.height_mm, 180 * 55 + 20));
  CHECK_THROWS_AS(high(56), UsageError); // over 10 m
  CHECK_NOTHROW(high(0));
  CHECK_THROWS_AS(place_on_page({{0, 0}, {1, 1}}, {.width_mm = 20, .height_mm = std::nullopt}),
                  UsageError);
}

TEST_CASE("a cropped page ends where the picture ends, which stays as large") {
  for (const double shape : {0.05, 0.5, 190.0 / 277, 1.0, 277.0 / 190, 8.0}) {
    const Box2 window{{2, 3}, {3, 3 + shape}};
    const Placement whole = place_on_page(window, {}),
                    cropped = place_on_page(window, {.crop = true});
    CHECK(cropped.to_page.m[0] == whole.to_page.m[0]); // mm for a unit
    const Vec2 low = cropped.to_page(window.low), high = cropped.to_page(window.high);
    const Box2 inner = cropped.page.inner_mm();
    CHECK(near(low.x, inner.low.x));
    CHECK(near(high.x, inner.high.x));
    CHECK(near(high.y, inner.low.y));
    CHECK(near(low.y, inner.high.y));
    CHECK(std::max(cropped.page.width_mm - whole.page.width_mm,
                   cropped.page.height_mm - whole.page.height_mm) <= kTolerance_mm);
  }
}

TEST_CASE("a scale is millimetres on the page for metres of the picture") {
  const Box2 window{{100, 200}, {5100, 3200}}; // 5 x 3 km
  const Placement placed = place_on_page(window, {.scale = 25000});
  CHECK(placed.page.width_mm == 297);
  CHECK(near(placed.to_page({1100, 300}).x - placed.to_page({100, 300}).x, 40));
  CHECK(near(placed.to_page({100, 300}).y - placed.to_page({100, 1300}).y, 40));
  CHECK(near(placed.to_page(window.centre()).x, 148.5));
  const Placement cropped = place_on_page(window, {.crop = true, .scale = 25000});
  CHECK(near(cropped.page.width_mm, 220));
  CHECK(near(cropped.page.height_mm, 140));
  const Placement wide =
      place_on_page(window, {.width_mm = 400, .height_mm = std::nullopt, .scale = 25000});
  CHECK(wide.page.width_mm == 400);
  CHECK(near(wide.page.height_mm, 140));
}

TEST_CASE("a scale at which the picture is larger than the page names one that fits, and a page") {
  for (const double scale : {100.0, 9999.0, 12500.0}) {
    const Box2 window{{0, 0}, {5000, 3000}};
    PageRequest request{.scale = scale};
    try {
      place_on_page(window, request);
      FAIL("it was placed");
    } catch (const UsageError& error) {
      const std::string right = error.right();
      CAPTURE(right);
      const auto after = [&](const std::string& words) {
        const auto at = right.find(words);
        REQUIRE(at != std::string::npos);
        return right.substr(at + words.size());
      };
      const double fits = std::stod(after("1:"));
      CHECK_NOTHROW(place_on_page(window, {.scale = fits}));
      CHECK_THROWS_AS(place_on_page(window, {.scale = 0.9 * fits}), UsageError);
      if (scale == 100) { // 50 m of paper
        CHECK(right.find("`page`") == std::string::npos);
        continue;
      }
      std::size_t digits = 0;
      const std::string size = after("`page` of ");
      request.width_mm = std::stod(size, &digits);
      request.height_mm = std::stod(size.substr(digits + 1));
      request.orientation = Orientation::as_given;
      CHECK_NOTHROW(place_on_page(window, request));
    }
  }
  // What is made to measure fits.
  CHECK_NOTHROW(place_on_page({{0, 0}, {2770, 1900}}, {.scale = 10000}));
}
