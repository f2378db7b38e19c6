// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/box.hpp"
#include "geometry/homography.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

using namespace orograph;

namespace {

Homography random_homography(Random& random) {
  Homography h;
  for (double& element : h.m) element = random.between(-1, 1);
  h.m[8] = 5; // so that w > 0 near the middle
  return h;
}

} // namespace

TEST_CASE("composed homographies act one after the other") {
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Homography inner = random_homography(random), outer = random_homography(random);
    const Vec2 p{random.between(-1, 1), random.between(-1, 1)};
    const Vec2 expected = outer(inner(p)), found = compose(outer, inner)(p);
    REQUIRE(std::abs(found.x - expected.x) <= 1e-14);
    REQUIRE(std::abs(found.y - expected.y) <= 1e-14);
  }
}

TEST_CASE("mm_per_y is how far a small step of Y goes") {
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Homography h = random_homography(random);
    const Vec2 p{random.between(-1, 1), random.between(-1, 1)};
    const double step = 1e-5;
    const Vec2 moved = h({p.x, p.y + step}) - h({p.x, p.y - step});
    // A central difference is off by a third derivative times step squared, here below 1e-10.
    REQUIRE(std::abs(h.mm_per_y(p) - length(moved) / (2 * step)) <= 1e-9);
  }
}

TEST_CASE("a box includes what it is given, and is empty before") {
  Box3 box;
  CHECK(box.empty());
  box.include({1, -2, 3});
  CHECK_FALSE(box.empty());
  box.include({-1, 5, 3});
  CHECK(box.low == Vec3{-1, -2, 3});
  CHECK(box.high == Vec3{1, 5, 3});
  CHECK(box.centre() == Vec3{0, 1.5, 3});
  Box2 flat;
  CHECK(flat.empty());
  flat.include({4, 4});
  flat.include({2, 7});
  CHECK(flat.width() == 2);
  CHECK(flat.height() == 3);
}
