// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that cross, nearly cross and nearly coincide: what is left never crosses, stays near what
// was given, and has all of its ends.
#include "dem/triangulate/plan_arrangement.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace orograph::plan_arrangement_test {
namespace {

/// Exact for coordinates from 1/4 to 8: they are multiples of 2^-58.
int side(Vec2 a, Vec2 b, Vec2 c) {
  __extension__ typedef __int128 Whole;
  const auto whole = [](double v) { return static_cast<Whole>(std::ldexp(v, 58)); };
  const Whole left = (whole(b.x) - whole(a.x)) * (whole(c.y) - whole(a.y));
  const Whole right = (whole(b.y) - whole(a.y)) * (whole(c.x) - whole(a.x));
  return left > right ? 1 : left < right ? -1 : 0;
}

double distance_m(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double share = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  return length(p - (a + share * along));
}

} // namespace

TEST_CASE("lines are bent so that they cross at their points only") {
  const double reach = 0x1p-40;
  for (std::uint64_t seed = 1; seed <= last_seed(120); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const int kind = random.whole(0, 3);
    std::vector<std::vector<Vec2>> lines;
    const auto place = [&]() -> Vec2 {
      if (kind == 0) return {random.whole(1, 12) / 3.0, random.whole(1, 12) / 3.0};
      const double x = random.between(0.5, 4), y = random.between(0.5, 4);
      if (kind == 1) return {x, y};
      // Nearly on one line, or nearly in a few places.
      if (kind == 2) return {x, 0.5 + x / 3 + random.between(-1, 1) * 0x1p-42};
      return {std::round(x) + 0.1 + random.whole(-3, 3) * 0x1p-41,
              std::round(y) + random.whole(-3, 3) * 0x1p-41};
    };
    for (int i = random.whole(2, 25); i > 0; --i) {
      auto& line = lines.emplace_back();
      for (int k = random.whole(2, 4); k > 0; --k) line.push_back(place());
    }
    std::vector<Vec2> fixed;
    for (const auto& line : lines) fixed.insert(fixed.end(), line.begin(), line.end());
    const UncrossedLines found = uncross(lines, fixed, reach);

    REQUIRE(found.lines.size() == lines.size());
    std::set<Step> steps;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const Step& step : found.lines[i]) {
        steps.insert({std::min(step[0], step[1]), std::max(step[0], step[1])});
        for (const std::uint32_t end : step) {
          double nearest = HUGE_VAL;
          for (std::size_t k = 1; k < lines[i].size(); ++k)
            if (lines[i][k] != lines[i][k - 1])
              nearest =
                  std::min(nearest, distance_m(found.points[end], lines[i][k - 1], lines[i][k]));
          REQUIRE(nearest <= 16 * reach);
        }
      }
      if (kind > 1 || found.lines[i].empty()) continue; // there steps may be left out
      REQUIRE(found.points[found.lines[i].front()[0]] == lines[i].front());
      REQUIRE(found.points[found.lines[i].back()[1]] == lines[i].back());
      for (std::size_t k = 1; k < found.lines[i].size(); ++k)
        REQUIRE(found.lines[i][k][0] == found.lines[i][k - 1][1]);
    }
    for (const auto& [a, b] : steps)
      for (const auto& [c, d] : steps) {
        const Vec2 pa = found.points[a], pb = found.points[b], pc = found.points[c],
                   pd = found.points[d];
        const bool cross =
            side(pa, pb, pc) * side(pa, pb, pd) < 0 && side(pc, pd, pa) * side(pc, pd, pb) < 0;
        if (cross) REQUIRE_FALSE(cross);
      }
  }
}

} // namespace orograph::plan_arrangement_test
