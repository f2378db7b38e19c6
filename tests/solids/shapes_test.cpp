// SPDX-License-Identifier: GPL-3.0-or-later
// Building blocks: closed, outward, and with the edges that the sources state.
#include "solids/plane_polygon.hpp"
#include "solids/shapes.hpp"
#include "tests/solids/made_outline.hpp"
#include "tests/solids/solid_facts.hpp"
#include "tests/support/random.hpp"
#include "tests/view/matrices.hpp"

using namespace orograph;

TEST_CASE("a box stands on z = 0, centred") {
  const Solid solid = box({8, 6, 3});
  require_closed(solid);
  CHECK(drawn_edges(solid) == 12);
  CHECK(volume_of(solid) == Approx(144));
  for (const Vec3 p : solid.vertices_m) {
    CHECK(std::abs(p.x) == 4);
    CHECK(std::abs(p.y) == 3);
    CHECK((p.z == 0 || p.z == 3));
  }
}

TEST_CASE("prisms and pyramids over random outlines") {
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const std::vector<Vec2> base = any_outline(random);
    const std::size_t n = base.size();
    const double area = std::abs(signed_area(base)), height = random.between(0.01, 30);

    const Solid upright = prism(base, height);
    require_closed(upright);
    REQUIRE(upright.vertices_m.size() == 2 * n);
    REQUIRE(drawn_edges(upright) == 3 * n);
    REQUIRE(euler_of(upright) == 2);
    REQUIRE(volume_of(upright) == Approx(area * height));

    const Vec3 apex{random.between(-50, 50), random.between(-50, 50), height};
    const Solid pointed = pyramid(base, random.chance(0.5) ? Apex(apex) : Apex(height));
    require_closed(pointed);
    REQUIRE(pointed.vertices_m.size() == n + 1);
    REQUIRE(drawn_edges(pointed) == 2 * n);
    REQUIRE(euler_of(pointed) == 2);
    REQUIRE(volume_of(pointed) == Approx(area * height / 3));
  }
}

TEST_CASE("exercise 9.2: the tetrahedron has six lines, the pyramid eight") {
  const std::array<Vec3, 4> corners{Vec3{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const auto& vertices : {corners, {corners[1], corners[0], corners[2], corners[3]}}) {
    const Solid solid = tetrahedron(vertices);
    require_closed(solid);
    CHECK(solid.vertices_m.size() == 4);
    CHECK(drawn_edges(solid) == 6);
    CHECK(volume_of(solid) == Approx(8.0 / 3));
  }
  const Solid solid = pyramid({{1, 1}, {1, -1}, {-1, -1}, {-1, 1}}, 2.5); // y there is z here
  require_closed(solid);
  CHECK(solid.vertices_m.size() == 5);
  CHECK(solid.vertices_m.back() == Vec3{0, 0, 2.5});
  CHECK(drawn_edges(solid) == 8);
}

TEST_CASE("random tetrahedra, in either orientation") {
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    std::array<Vec3, 4> v;
    for (Vec3& p : v) p = {random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
    const double six = dot(cross(v[1] - v[0], v[2] - v[0]), v[3] - v[0]);
    if (std::abs(six) < 1e-3) continue;
    const Solid solid = tetrahedron(v);
    require_closed(solid);
    REQUIRE(volume_of(solid) == Approx(std::abs(six) / 6));
  }
}

TEST_CASE("the middle of a pyramid's base is that of its corners") {
  const Solid solid = pyramid({{0, 0}, {6, 0}, {0, 3}}, 1.0);
  CHECK(distance(solid.vertices_m.back(), {2, 1, 1}) < 1e-15);
}

TEST_CASE("flat shapes are refused") {
  check_refused([] { box({1, 0, 1}); }, "the box is flat");
  check_refused([] { box({1, 1, -1}); }, "the box is flat");
  check_refused([] { prism({{0, 0}, {1, 0}, {0, 1}}, 0); }, "the prism is flat");
  check_refused([] { prism({{0, 0}, {1, 0}}, 1); }, "the base has fewer than three corners");
  check_refused([] { prism({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 1); }, "the base crosses or touches");
  check_refused([] { prism({{0, 0}, {1, 0}, {2, 0}}, 1); }, "the base turns back along itself");
  check_refused([] { pyramid({{0, 0}, {1, 0}, {0, 1}}, 0.0); }, "apex isn't above its base");
  check_refused([] { pyramid({{0, 0}, {1, 0}, {0, 1}}, Vec3{0, 0, -1}); }, "apex isn't above");
  check_refused(
      [] {
        tetrahedron({Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
      },
      "has no volume");
}
