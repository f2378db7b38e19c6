// SPDX-License-Identifier: GPL-3.0-or-later
// Points on straight lines: on segments of the visibility plane, and in space by their picture.
#include "geometry/profile_point.hpp"
#include "geometry/segment.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <limits>

using namespace orograph;

TEST_CASE("a segment's height is exact at both ends and right to rounding between") {
  for (std::uint64_t seed = 1; seed <= last_seed(3000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const double offset = random.pick({0.0, 1.0, 1e6});
    const double x0 = offset + random.between(-1, 1);
    const double size = random.pick({1e-9, 1e-3, 1.0, 100.0});
    const double y0 = random.between(-1, 1),
                 y1 = y0 + random.pick({1e-12, 1.0, 1e6}) * random.share();
    const Segment s{x0, y0, x0 + size, y1, 0};
    if (!(s.x0 < s.x1)) continue;
    REQUIRE(height_at(s, s.x0) == s.y0);
    REQUIRE(height_at(s, s.x1) == s.y1);
    const double x = std::clamp(s.x0 + random.share() * (s.x1 - s.x0), s.x0, s.x1);
    const long double t =
        (static_cast<long double>(x) - s.x0) / (static_cast<long double>(s.x1) - s.x0);
    const long double expected = s.y0 + t * (static_cast<long double>(s.y1) - s.y0);
    const double slope = std::abs((s.y1 - s.y0) / (s.x1 - s.x0));
    const double ulp = std::numeric_limits<double>::epsilon();
    const double bound =
        4 * ulp * std::max(std::abs(s.y0), std::abs(s.y1)) + slope * ulp * std::abs(x);
    REQUIRE(std::abs(static_cast<double>(height_at(s, x) - expected)) <= bound);
  }
}

TEST_CASE("the share in depth is that of the point with this picture") {
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const ProfilePoint a{random.between(-9, 9), random.between(0.1, 9), random.between(-9, 9)};
    const ProfilePoint b{random.between(-9, 9), random.between(0.1, 900), random.between(-9, 9)};
    REQUIRE(share_in_depth(0, a.v, b.v) == 0);
    REQUIRE(share_in_depth(1, a.v, b.v) == 1);
    const double share = random.share();
    const ProfilePoint p = point_between(a, b, share_in_depth(share, a.v, b.v));
    const auto picture = [&](double from, double to) { return from + share * (to - from); };
    REQUIRE(std::abs(p.u / p.v - picture(a.u / a.v, b.u / b.v)) <= 1e-12);
    REQUIRE(std::abs(p.z / p.v - picture(a.z / a.v, b.z / b.v)) <= 1e-12);
    const ProfilePoint begin = point_between(a, b, 0), end = point_between(a, b, 1);
    REQUIRE((begin.u == a.u && begin.v == a.v && begin.z == a.z));
    REQUIRE((end.u == b.u && end.v == b.v && end.z == b.z));
  }
}
