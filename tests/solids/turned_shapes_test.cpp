// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of revolution and of rotation.
#include "solids/plane_polygon.hpp"
#include "solids/shapes.hpp"
#include "tests/solids/made_outline.hpp"
#include "tests/solids/solid_facts.hpp"
#include "tests/support/random.hpp"
#include "tests/view/matrices.hpp"

using namespace orograph;

namespace {

// What a polygon counterclockwise in (r, z) encloses when its corners turn in N steps: level
// sections are regular N-gons.
double turned_volume(const std::vector<Vec2>& polygon, int sides) {
  double integral = 0; // of r^2 dz
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    integral += (q.y - p.y) * (p.x * p.x + p.x * q.x + q.x * q.x) / 3;
  }
  return std::abs(integral) * sides / 2 * std::sin(2 * M_PI / sides);
}

std::size_t level_edges(const Solid& solid, bool level) {
  return static_cast<std::size_t>(
      std::count_if(solid.edges.begin(), solid.edges.end(), [&](const SolidEdge& e) {
        const double rise = solid.vertices_m[e.to].z - solid.vertices_m[e.from].z;
        return !e.smooth && (std::abs(rise) < 1e-12) == level;
      }));
}

Turning spheroid(bool smooth) { // listing 9.11: NUMV 8, NUMH 10, PHI pi/25
  Turning turning{{}, 10, Angle::degrees(180.0 / 25), smooth};
  for (int i = 0; i <= 8; ++i)
    turning.profile_m.push_back(
        {std::cos(M_PI / 2 - i * M_PI / 8), std::sin(M_PI / 2 - i * M_PI / 8)});
  turning.profile_m.back().x = 1.8e-16; // as rounding may have it
  return turning;
}

std::vector<Vec2> rising_profile(Random& random) {
  std::vector<Vec2> profile;
  const int points = random.whole(2, 12);
  for (int i = 0; i < points; ++i)
    profile.push_back({random.between(0.2, 5), i + random.between(0, 0.8)});
  if (random.chance(0.5)) profile.front().x = 0;
  if (random.chance(0.5) && points > 2) profile.back().x = 0;
  return profile;
}

} // namespace

TEST_CASE("listing 9.11: the spheroid has 80 vertical lines and 70 horizontal ones") {
  const Solid solid = revolution(spheroid(false));
  require_closed(solid);
  CHECK(solid.vertices_m.size() == 72);
  CHECK(level_edges(solid, false) == 80);
  CHECK(level_edges(solid, true) == 70);
  CHECK(drawn_edges(solid) == 150);
  CHECK(euler_of(solid) == 2);
  // PHI turns the first vertical set.
  CHECK(std::any_of(solid.vertices_m.begin(), solid.vertices_m.end(), [](Vec3 p) {
    return distance(p, {std::cos(M_PI / 25), std::sin(M_PI / 25), 0}) < 1e-15;
  }));
}

TEST_CASE("bodies of revolution from random profiles, in both directions") {
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    Turning turning{rising_profile(random), random.whole(3, 40),
                    Angle::degrees(random.between(-400, 400)), random.chance(0.5)};
    std::vector<Vec2> polygon = turning.profile_m;
    polygon.push_back({0, polygon.back().y});
    polygon.push_back({0, polygon.front().y});
    const Solid solid = revolution(turning);
    require_closed(solid);
    REQUIRE(euler_of(solid) == 2);
    REQUIRE(volume_of(solid) == Approx(turned_volume(polygon, turning.sides)));
    std::reverse(turning.profile_m.begin(), turning.profile_m.end());
    const Solid other = revolution(turning);
    REQUIRE(other == solid);
  }
}

TEST_CASE("rings from random closed profiles") {
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    std::vector<Vec2> polygon = star_outline(random, random.whole(3, 20));
    for (Vec2& p : polygon) p.x += 100;
    if (random.chance(0.5)) std::reverse(polygon.begin(), polygon.end());
    Turning turning{polygon, random.whole(3, 30), Angle(), random.chance(0.5)};
    turning.profile_m.push_back(polygon.front());
    const Solid solid = revolution(turning);
    require_closed(solid);
    REQUIRE(euler_of(solid) == 0);
    REQUIRE(volume_of(solid) == Approx(turned_volume(polygon, turning.sides)));
    if (!turning.smooth) REQUIRE(drawn_edges(solid) == 2 * polygon.size() * turning.sides);
  }
}

TEST_CASE("profiles that meet the axis in other ways") {
  // A cylinder, told as what the axis closes and as an open line.
  const Solid closed = revolution({{{0, 0}, {2, 0}, {2, 5}, {0, 5}, {0, 0}}, 12, {}, false});
  const Solid open = revolution({{{2, 0}, {2, 5}}, 12, {}, false});
  require_closed(closed);
  require_closed(open);
  CHECK(volume_of(closed) == Approx(volume_of(open)));
  CHECK(drawn_edges(open) == 36);
  // An hourglass: two cones that share their tip.
  const Solid glass = revolution({{{1, 0}, {0, 1}, {1, 2}}, 8, {}, false});
  require_closed(glass);
  CHECK(euler_of(glass) == 3);
}

TEST_CASE("smooth: what is drawn of a curved surface besides its outline") {
  // A sphere: nothing, since it bends by 22.5 degrees with 8 pieces, and by 18 with 10.
  CHECK(drawn_edges(revolution(spheroid(true))) == 70);
  Turning fine{{}, 10, {}, true};
  for (int i = 0; i <= 10; ++i) {
    const Angle at = Angle::degrees(18.0 * i - 90);
    fine.profile_m.push_back({cos(at), sin(at)});
  }
  CHECK(drawn_edges(revolution(fine)) == 0);
  // A cylinder: the edges of its caps. A lighthouse: its gallery too.
  CHECK(drawn_edges(revolution({{{2, 0}, {2, 5}}, 24, {}, true})) == 48);
  CHECK(drawn_edges(revolution(
            {{{3, 0}, {2.6, 6}, {2, 12}, {2.5, 12}, {2.5, 13}, {0, 15}}, 24, {}, true})) == 96);
  // A bowl on a foot, whose caps' edges stand above each other.
  CHECK(drawn_edges(revolution({{{2, 0}, {2, 1}, {4, 1}, {4, -1}, {2, -1}}, 24, {}, true})) == 120);
  // A ring of 12 corners bends by 30 degrees at each.
  Turning ring{{}, 9, {}, true};
  for (int i = 0; i <= 12; ++i)
    ring.profile_m.push_back(
        {5 + cos(Angle::degrees(30.0 * (i % 12))), sin(Angle::degrees(30.0 * (i % 12)))});
  CHECK(drawn_edges(revolution(ring)) == 108);
}

TEST_CASE("bodies of rotation: closed, and as large as Pappus says") {
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    std::vector<Vec2> section = star_outline(random, random.whole(3, 12));
    for (Vec2& p : section) p.x += 100;
    if (random.chance(0.5)) std::reverse(section.begin(), section.end());
    const int sides = random.whole(60, 90), steps = random.whole(1, 3 * sides);
    const Turning turning{section, sides, Angle::degrees(random.between(-90, 90)),
                          random.chance(0.5)};
    const Rise rise{random.pick({-1.0, 1.0}) * random.between(21, 40),
                    static_cast<double>(steps) / sides};
    const Solid solid = rotation_body(turning, rise);
    require_closed(solid);
    const auto n = section.size();
    REQUIRE(euler_of(solid) == 2);
    REQUIRE(solid.vertices_m.size() == n * (steps + 1));
    if (!turning.smooth) REQUIRE(drawn_edges(solid) == n * (2 * steps + 1));
    // A step is a sheared sector, but for what lies between the quadrangles' two diagonals.
    double between = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double across = section[(i + 1) % n].x - section[i].x;
      between += across * across * std::sin(2 * M_PI / sides) * rise.per_turn_m / sides / 12;
    }
    const double sector = turned_volume(section, sides) / sides;
    REQUIRE(volume_of(solid) == Approx(steps * (sector + between)).epsilon(1e-9));
  }
}

TEST_CASE("a spiral rises as it is told, its profile closed or not") {
  const std::vector<Vec2> section{{2, 0}, {3, 0}, {3, 0.5}, {2, 0.5}};
  std::vector<Vec2> again = section;
  again.push_back(section.front());
  const Solid solid = rotation_body({section, 12, {}, false}, {4, 2.5});
  CHECK(solid == rotation_body({again, 12, {}, false}, {4, 2.5}));
  CHECK(distance(solid.vertices_m.front(), {2, 0, 0}) < 1e-15);
  CHECK(distance(solid.vertices_m[48], {2, 0, 4}) < 1e-14);
  CHECK(distance(solid.vertices_m[120], {-2, 0, 10}) < 1e-14);
  // Smooth: its four helices, and its two ends.
  CHECK(drawn_edges(rotation_body({section, 12, {}, true}, {4, 2.5})) == 4 * 30 + 8);
  // Half an arch lies flat.
  require_closed(rotation_body({section, 12, {}, false}, {0, 0.5}));
}

TEST_CASE("profiles that leave no body are refused") {
  const auto revolved = [](std::vector<Vec2> profile, int sides, const char* words) {
    check_refused([&] { revolution({profile, sides, {}, false}); }, words);
  };
  revolved({{1, 0}, {1, 1}}, 2, "there are 2 sides to a turn");
  revolved({{1, 0}, {1, 1}}, 10001, "there are 10001 sides to a turn");
  revolved({{1, 0}}, 5, "the profile is no line");
  revolved({{1, 0}, {-1, 1}}, 5, "point 1 of the profile is beyond the axis");
  revolved({{0, 0}, {0, 1}, {0, 2}}, 5, "the profile encloses nothing");
  revolved({{0, 0}, {1, 0}}, 5, "the profile encloses nothing");
  revolved({{1, 0}, {3, 2}, {3, 0}, {1, 2}}, 5, "crosses or touches itself");
  revolved({{1, 0}, {2, -1}, {0.5, 0}, {0.5, 3}}, 5, "the profile crosses or touches a cap");
  revolved(std::vector<Vec2>(200, Vec2{1, 0}), 10000, "it would have 2000000 faces");
  const auto rotated = [](std::vector<Vec2> profile, Rise rise, const char* words) {
    check_refused([&] { rotation_body({profile, 12, {}, false}, rise); }, words);
  };
  const std::vector<Vec2> section{{2, 0}, {3, 0}, {2, 1}};
  rotated({{2, 0}, {3, 0}}, {2, 1}, "the profile is no polygon");
  rotated({{0, 0}, {3, 0}, {2, 1}}, {2, 1}, "point 0 of the profile is on the axis");
  rotated({{2, 0}, {3, 1}, {3, 0}, {2, 1}}, {2, 1}, "crosses or touches itself");
  rotated(section, {2, 1.3}, "1.3 turns of 12 sides are 15.6 steps");
  rotated(section, {2, 0}, "are 0 steps");
  rotated(section, {2, -1}, "are -12 steps");
  rotated(section, {0, 1}, "a whole turn without a rise");
  rotated(section, {2, 1e6}, "faces");
}
