// SPDX-License-Identifier: GPL-3.0-or-later
// Lines stay what they are however often rounding moves them.
#include "dem/tin.hpp"
#include "dem/triangulate/plane_triangulation.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace orograph::plane_triangulation_test {
namespace {

struct Lines {
  std::vector<Vec2> places;
  std::vector<std::array<std::uint32_t, 2>> ends;
};

void add(Lines& lines, Vec2 a, Vec2 b) {
  if (a == b) return;
  std::array<std::uint32_t, 2> ends{};
  for (int k = 0; k < 2; ++k) {
    const auto at = std::find(lines.places.begin(), lines.places.end(), k == 0 ? a : b);
    ends[k] = static_cast<std::uint32_t>(at - lines.places.begin());
    if (at == lines.places.end()) lines.places.push_back(k == 0 ? a : b);
  }
  lines.ends.push_back(ends);
}

// Each line goes from its first end to its last along edges, and nowhere far from straight.
void check_lines(const Lines& lines, double tolerance_m) {
  PlaneTriangulation plane(lines.places);
  if (!plane.has_area()) return;
  std::vector<std::uint32_t> numbers;
  for (const auto& [from, to] : lines.ends) numbers.push_back(plane.add_line(from, to));
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const auto& t : plane.mesh().triangles)
    for (int k = 0; k < 3; ++k) {
      edges.insert({t[k], t[(k + 1) % 3]});
      edges.insert({t[(k + 1) % 3], t[k]});
    }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto line = plane.line(numbers[i]);
    REQUIRE(line.front() == lines.ends[i][0]);
    REQUIRE(line.back() == lines.ends[i][1]);
    const Vec2 from = plane.places()[line.front()], along = plane.places()[line.back()] - from;
    for (std::size_t k = 1; k < line.size(); ++k) {
      REQUIRE(edges.count({line[k - 1], line[k]}) == 1);
      const Vec2 to = plane.places()[line[k]] - from;
      REQUIRE(std::abs(cross(along, to)) <= tolerance_m * length(along));
    }
  }
}

} // namespace

TEST_CASE("lines a few units in the last place apart stay whole and straight") {
  Random random(1);
  constexpr double origin = 1e9, unit = 0x1p-23;
  for (int round = 0; round < rounds(400); ++round) {
    Lines lines;
    const int side = random.whole(2, 40);
    const double step = random.pick({1., 30., 1e6}) * unit;
    const auto place = [&] {
      return Vec2{origin + step * random.whole(0, side), origin + unit * random.whole(0, side)};
    };
    for (int k = random.whole(3, 40); k > 0; --k) add(lines, place(), place());
    check_lines(lines, 64 * unit);
  }
}

TEST_CASE("splits that only rounding asks for come to an end") {
  // Found among thousands of such: without regard to rounding, lines of the first push each other
  // about for ever.
  constexpr double origin = 1e9, unit = 0x1p-23;
  for (int seed = 138; seed < 168; ++seed) {
    Random random(seed);
    const int count = random.whole(3, 60), side = random.whole(2, 12);
    std::vector<Vec2> places;
    for (int k = 0; k < 2 * count; ++k) {
      const double east = origin + unit * random.whole(0, 1000) * (k % 2 ? 1e6 : 1);
      const double north = origin + unit * random.whole(0, side);
      places.push_back({east, north});
    }
    Lines lines;
    for (int k = 0; k < count; ++k) add(lines, places[2 * k], places[2 * k + 1]);
    check_lines(lines, 64 * unit);
  }
}

TEST_CASE("hundreds of crossings don't carry a line away") {
  Random random(2);
  Lines across, star;
  for (int k = 0; k < 120; ++k) {
    add(across, {random.share(), random.between(0, 1000)},
        {999 + random.share(), random.between(0, 1000)});
    const double angle = random.between(0, 7);
    const Vec2 far{100 * std::cos(angle), 100 * std::sin(angle)};
    add(star, Vec2{7, 3} + far, Vec2{7 + random.between(-1e-9, 1e-9), 3} - far);
  }
  check_lines(across, 1e-11);
  check_lines(star, 1e-11);
}

TEST_CASE("a place is told by its vertex, its edge or its triangle, exactly") {
  const std::vector<Vec2> places{{0, 0}, {8, 0}, {0, 8}};
  PlaneTriangulation plane(places);
  const auto mean = [&](const std::vector<Share>& shares) {
    Vec2 sum;
    for (const auto& [vertex, share] : shares) sum = sum + share * places[vertex];
    return sum;
  };
  CHECK(plane.around({8, 0}).size() == 1);
  CHECK(plane.around({4, 0}).size() == 2);
  CHECK(plane.around({1, 3}).size() == 3);
  CHECK(plane.around({5, 5}).empty());
  for (const Vec2 p : {Vec2{8, 0}, {4, 0}, {3, 5}, {1, 3}}) CHECK(mean(plane.around(p)) == p);

  // Within a needle a billion times longer than wide.
  const std::vector<Vec2> needle{{0, 0}, {1e3, 1e3}, {1e3 + 1e-6, 1e3}};
  PlaneTriangulation thin(needle);
  const Vec2 inside{500 + 2.5e-7, 500};
  const auto shares = thin.around(inside);
  REQUIRE(shares.size() == 3);
  double at_start = 0;
  for (const auto& [vertex, share] : shares)
    if (vertex == 0) at_start = share;
  CHECK(at_start == 0.5);
}

} // namespace orograph::plane_triangulation_test
