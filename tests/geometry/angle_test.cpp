// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/angle.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <limits>
#include <numbers>

using namespace orograph;

TEST_CASE("sines and cosines are exact at multiples of 90 degrees") {
  const double sines[4] = {0, 1, 0, -1};
  for (int turn = -12; turn <= 4000; ++turn) {
    const Angle a = Angle::degrees(90.0 * turn);
    CAPTURE(turn);
    REQUIRE(sin(a) == sines[(turn + 12) % 4]);
    REQUIRE(cos(a) == sines[(turn + 13) % 4]);
  }
}

TEST_CASE("sines and cosines elsewhere are right to rounding, and odd and even") {
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Angle a = Angle::degrees(random.between(-720, 720));
    const long double radians = a.in_degrees() * std::numbers::pi_v<long double> / 180;
    constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();
    REQUIRE(std::abs(sin(a) - static_cast<double>(std::sin(radians))) <= rounding);
    REQUIRE(std::abs(cos(a) - static_cast<double>(std::cos(radians))) <= rounding);
    REQUIRE(sin(-a) == -sin(a));
    REQUIRE(cos(-a) == cos(a));
    const double expected = static_cast<double>(std::tan(radians));
    REQUIRE(std::abs(tan(a) - expected) <= 4 * rounding * (1 + expected * expected));
    REQUIRE(std::abs(a.in_radians() - static_cast<double>(radians)) <= 8 * rounding);
  }
}

TEST_CASE("opposite azimuths are exactly opposite directions") {
  for (int azimuth = -360; azimuth <= 360; ++azimuth) {
    const Vec2 ahead = direction_of_azimuth(Angle::degrees(azimuth));
    REQUIRE(direction_of_azimuth(Angle::degrees(azimuth + 180)) == -1.0 * ahead);
    REQUIRE(std::abs(length(ahead) - 1) <= 2e-16);
  }
  CHECK(direction_of_azimuth(Angle::degrees(0)) == Vec2{0, 1});
  CHECK(direction_of_azimuth(Angle::degrees(90)) == Vec2{1, 0});
  const Vec2 north_east = direction_of_azimuth(Angle::degrees(30));
  CHECK(std::abs(north_east.x - 0.5) <= 1e-15);
  CHECK(north_east.y > 0);
}

TEST_CASE("the angle of a vector, exact on the axes") {
  CHECK(atan2_angle(0, 1) == Angle::degrees(0));
  CHECK(atan2_angle(0, 0) == Angle::degrees(0));
  CHECK(atan2_angle(2, 0) == Angle::degrees(90));
  CHECK(atan2_angle(0, -3) == Angle::degrees(180));
  CHECK(atan2_angle(-0.0, -3) == Angle::degrees(180)); // never -180
  CHECK(atan2_angle(-1, 0) == Angle::degrees(-90));
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const double degrees = random.between(-180, 180);
    const Angle a = Angle::degrees(degrees);
    CHECK(std::abs(atan2_angle(5 * sin(a), 5 * cos(a)).in_degrees() - degrees) <= 1e-13);
  }
}
