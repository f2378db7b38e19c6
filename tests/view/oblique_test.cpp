// SPDX-License-Identifier: GPL-3.0-or-later
// Oblique views by what draughtsmen expect of them.
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/view/made_terrain.hpp"

using namespace orograph;

namespace {

View oblique_view(const MadeTerrain& terrain, Oblique oblique, double from_azimuth_deg,
                  double exaggeration = 1, double roll_deg = 0) {
  ViewRequest request;
  request.projection = Projection::oblique;
  request.oblique = oblique;
  request.from_azimuth = Angle::degrees(from_azimuth_deg);
  request.exaggeration = exaggeration;
  request.roll = Angle::degrees(roll_deg);
  return place_view(request, terrain.shape(), 0.7);
}

// Of two ground points, as drawn.
Vec2 drawn(const View& view, Vec3 from, Vec3 to) {
  return picture_of(view, to) - picture_of(view, from);
}

} // namespace

TEST_CASE("across and up are true, and away from the viewer is as long and as steep as asked") {
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    const MadeTerrain terrain = made_terrain(random, 8);
    const Oblique oblique{random.between(0.1, 2), Angle::degrees(random.between(0, 180))};
    const double azimuth = random.pick({180.0, 225.0, random.between(0, 360)});
    const double exaggeration = random.pick({1.0, 2.5});
    const View view = oblique_view(terrain, oblique, azimuth, exaggeration);
    const double a = azimuth * std::numbers::pi / 180, length = random.between(1, 500);
    const Vec3 from{random.between(-500, 500), random.between(-500, 500), random.between(0, 500)};
    const Vec3 away{from.x - length * std::sin(a), from.y - length * std::cos(a), from.z};
    const Vec3 aside{from.x - length * std::cos(a), from.y + length * std::sin(a), from.z};
    const double rise = oblique.rise.in_radians();
    CAPTURE(seed, azimuth, oblique.length, rise);
    const auto near = [](Vec2 found, Vec2 right) { return largest(found - right) <= 1e-10; };
    CHECK(near(drawn(view, from, aside), {length, 0})); // what is on the right stays on the right
    CHECK(near(drawn(view, from, {from.x, from.y, from.z + length}), {0, exaggeration * length}));
    CHECK(near(drawn(view, from, away),
               oblique.length * length * Vec2{std::cos(rise), std::sin(rise)}));
  }
}

TEST_CASE("the names: cavalier, cabinet, military") {
  Random random(1);
  const MadeTerrain terrain = made_terrain(random, 8);
  const Vec3 from{10, 20, 30}, north{10, 120, 30};
  const double diagonal = 100 / std::numbers::sqrt2;
  CHECK(largest(drawn(oblique_view(terrain, kCavalier, 180), from, north) -
                Vec2{diagonal, diagonal}) <= 1e-11);
  CHECK(largest(drawn(oblique_view(terrain, kCabinet, 180), from, north) -
                0.5 * Vec2{diagonal, diagonal}) <= 1e-11);
  // The plan is true from any side, with heights drawn upwards.
  const View military = oblique_view(terrain, kMilitary, 225);
  for (int i = 0; i < 100; ++i) {
    const Vec3 a{random.between(-500, 500), random.between(-500, 500), 7},
        b{random.between(-500, 500), random.between(-500, 500), 7};
    CHECK(std::abs(length(drawn(military, a, b)) - length(b - a)) <= 1e-10);
  }
  CHECK(largest(drawn(military, from, {10, 20, 80}) - Vec2{0, 50}) <= 1e-11);
}

TEST_CASE("the window is the picture's box, but for what can't be seen at its lower side") {
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    const MadeTerrain terrain = made_terrain(random, 10, random.pick({0.0, 0.2}));
    const double roll = random.pick({0.0, 0.0, 180.0, random.between(-180, 180)});
    const View view =
        oblique_view(terrain, {random.between(0.1, 2), Angle::degrees(random.between(0, 180))},
                     random.between(0, 360), random.pick({1.0, 2.0}), roll);
    Box2 box;
    for (const Vec3& vertex : terrain.vertices) box.include(picture_of(view, vertex));
    CAPTURE(seed, roll);
    CHECK(std::abs(view.window.low.x - box.low.x) <= 1e-9);
    CHECK(std::abs(view.window.high.x - box.high.x) <= 1e-9);
    CHECK(std::abs(view.window.high.y - box.high.y) <= 1e-9);
    if (roll == 0)
      CHECK(view.window.low.y >= box.low.y - 1e-9);
    else
      CHECK(std::abs(view.window.low.y - box.low.y) <= 1e-9);
  }
}
