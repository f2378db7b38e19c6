// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/plane_polygon.hpp"
#include "tests/catch.hpp"
#include "tests/solids/made_outline.hpp"
#include "tests/support/random.hpp"

using namespace orograph;

namespace {

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

} // namespace

TEST_CASE("triangles fill a polygon, without any that is flat") {
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    std::vector<Vec2> outline = any_outline(random);
    REQUIRE(fault_of_line(outline, true).empty());
    if (signed_area(outline) < 0) std::reverse(outline.begin(), outline.end());
    const auto triangles = triangles_of(outline);
    REQUIRE(triangles.size() == outline.size() - 2);
    double area = 0;
    for (const auto& [a, b, c] : triangles) {
      const double one = cross(outline[b] - outline[a], outline[c] - outline[a]) / 2;
      REQUIRE(one > 0);
      area += one;
    }
    REQUIRE(area == Approx(signed_area(outline)));
  }
}

TEST_CASE("a convex polygon is a fan, one with corners in a row isn't") {
  using Fan = std::vector<std::array<std::uint32_t, 3>>;
  CHECK(triangles_of(std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}) ==
        Fan{{0, 1, 2}, {0, 2, 3}});
  const auto row = triangles_of(std::vector<Vec2>{{0, 0}, {1, 0}, {2, 0}, {2, 2}});
  CHECK(row.size() == 2);
}

TEST_CASE("what keeps a line from being simple") {
  const auto fault = [](std::vector<Vec2> line, bool closed) {
    return fault_of_line(line, closed);
  };
  CHECK(says(fault({{0, 0}, {2, 2}, {2, 0}, {0, 2}}, true), "crosses or touches itself"));
  CHECK(says(fault({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}, true), "crosses or touches itself"));
  CHECK(says(fault({{0, 0}, {4, 0}, {4, 4}, {4, 4}}, true), "corners 2 and 3 in one place"));
  CHECK(says(fault({{0, 0}, {4, 0}, {4, 4}, {0, 0}}, true), "corners 3 and 0 in one place"));
  CHECK(says(fault({{0, 0}, {4, 0}, {2, 0}, {2, 2}}, true), "turns back along itself at corner 1"));
  CHECK(says(fault({{0, 0}, {1, 1}, {2, 2}}, true), "turns back along itself"));
  CHECK(fault({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, false).empty());
  CHECK(says(fault({{0, 0}, {2, 0}, {2, 2}, {1, -1}}, false), "crosses or touches itself"));
  CHECK(says(fault({{0, 0}, {2, 0}, {2, 2}, {0, 0}}, false), "crosses or touches itself"));

  // Twice round is no polygon, though it turns to one side only.
  std::vector<Vec2> twice;
  for (int i = 0; i < 10; ++i) twice.push_back({std::cos(i * 1.3), std::sin(i * 1.3)});
  CHECK(says(fault_of_line(twice, true), "crosses or touches itself"));

  // A convex polygon may have any number of corners, another has a limit.
  std::vector<Vec2> circle;
  for (int i = 0; i < 6000; ++i)
    circle.push_back({std::cos(i * M_PI / 3000), std::sin(i * M_PI / 3000)});
  CHECK(fault_of_line(circle, true).empty());
  circle[7] = {0.1, 0.1};
  CHECK(says(fault_of_line(circle, true), "has over 5000 corners"));
}
