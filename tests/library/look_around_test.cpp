// SPDX-License-Identifier: GPL-3.0-or-later
// What an eye sees without a picture, by the library's face.
#include "tests/catch.hpp"
#include "tests/library/made_ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

namespace orograph::library_look_around_test {
namespace {

constexpr int kSide = 61;
constexpr double kDegree = std::numbers::pi / 180;

// Level ground at 100 m on a map that is nowhere on the earth, cells' centres at whole metres from
// (0, 0) to (60, 60), and a wall of 50 m along x = 50.
Session session_with_wall() {
  const auto heights =
      std::make_shared<std::vector<float>>(static_cast<std::size_t>(kSide) * kSide, 100.F);
  for (std::size_t row = 0; row < kSide; ++row) (*heights)[row * kSide + 50] = 150;
  GridInput input;
  input.columns = input.rows = kSide;
  input.heights = std::span<const float>(*heights);
  input.owner = heights;
  input.geotransform = {-0.5, 1, 0, 60.5, 0, -1};
  return Session(Terrain::of(input));
}

// 10 m above the ground, 40 m in front of the wall.
ViewSpec eye() {
  ViewSpec view;
  view.eye_map = GivenPlace(Vec3{10, 30, 110});
  return view;
}

} // namespace

TEST_CASE("Session::sights tells what is in front of a wall, on it and behind it") {
  const Session session = session_with_wall();
  const std::vector<Vec2> places{{30, 30}, {50, 30}, {58, 30}, {10, 58}, {200, 30}};
  const std::vector<PlaceSight> sights = session.sights(eye(), places);
  REQUIRE(sights.size() == places.size());
  CHECK(sights[0].state == PlaceState::seen);
  CHECK(sights[0].bearing.azimuth_deg == Approx(90).epsilon(1e-12));
  CHECK(sights[0].bearing.distance_m == Approx(20).epsilon(1e-12));
  CHECK(sights[0].bearing.altitude_deg == Approx(std::atan(-10.0 / 20) / kDegree).epsilon(1e-12));
  CHECK(sights[0].height == 100);
  CHECK(sights[1].state == PlaceState::seen);
  CHECK(sights[1].height == 150);
  CHECK(sights[1].bearing.altitude_deg == Approx(45).epsilon(1e-12)); // 40 m up, 40 m away
  // The line over the wall's top is 48 m above the eye at 48 m: 58 m above the ground.
  CHECK(sights[2].state == PlaceState::hidden);
  CHECK(sights[2].hidden_m == Approx(58).epsilon(1e-12));
  CHECK(sights[2].hidden_deg == Approx(45 + std::atan(10.0 / 48) / kDegree).epsilon(1e-12));
  CHECK(sights[3].state == PlaceState::seen);
  CHECK(sights[3].bearing.azimuth_deg == 0);
  CHECK(sights[4].state == PlaceState::outside);
  // A mast that stands higher than that is seen, whatever the number of threads.
  for (const int jobs : {1, 3}) {
    Control control;
    control.jobs = jobs;
    CHECK(session.sights(eye(), places, 58.1, control)[2].state == PlaceState::seen);
    CHECK(session.sights(eye(), places, 57.9, control)[2].state == PlaceState::hidden);
  }
}

TEST_CASE("Session::skyline is the wall's top, and the level ground's end elsewhere") {
  const Session session = session_with_wall();
  const Skyline skyline = session.skyline(eye(), 15);
  REQUIRE(skyline.directions.size() == 24);
  for (std::size_t i = 0; i < 24; ++i) {
    const double azimuth_deg = 15 * static_cast<double>(i);
    const auto& [told_deg, place] = skyline.directions[i];
    INFO("azimuth " << azimuth_deg);
    CHECK(told_deg == azimuth_deg);
    REQUIRE(place);
    const double east = std::sin(azimuth_deg * kDegree), north = std::cos(azimuth_deg * kDegree);
    // Northwards and southwards the wall goes on as far as the ground: 30 m.
    const bool meets_wall = east > 0 && 40 * std::abs(north) <= 30 * east;
    double away_m = meets_wall ? 40 / east : 1e9;
    if (!meets_wall)
      for (const double to_border : {east > 0 ? 50 / east : 1e9, east < 0 ? -10 / east : 1e9,
                                     north > 0 ? 30 / north : 1e9, north < 0 ? -30 / north : 1e9})
        away_m = std::min(away_m, to_border);
    const double up_m = meets_wall ? 40 : -10;
    CHECK(place->bearing.distance_m == Approx(away_m).epsilon(1e-9));
    CHECK(place->bearing.altitude_deg == Approx(std::atan(up_m / away_m) / kDegree).epsilon(1e-9));
    CHECK(place->height == Approx(meets_wall ? 150 : 100).epsilon(1e-9));
    CHECK(place->at_border == !meets_wall);
    CHECK(!place->lonlat);
  }
  REQUIRE(skyline.most_distant);
  // The wall's ends, 40 m east and 30 m north or south of the eye, are the farthest seen.
  CHECK(skyline.most_distant->bearing.distance_m == Approx(50).epsilon(1e-3));
}

TEST_CASE("What makes no sense of an eye that looks around is refused") {
  const Session session = session_with_wall();
  const std::vector<Vec2> places{{30, 30}};
  CHECK_THROWS_AS(session.sights({}, places), Error);
  CHECK_THROWS_AS(session.skyline({}), Error);
  CHECK_THROWS_AS(session.sights(eye(), places, -1), Error);
  CHECK_THROWS_AS(session.sights(eye(), {{std::nan(""), 0}}), Error);
  for (const double step_deg : {0.0, 91.0, std::nan("")})
    CHECK_THROWS_AS(session.skyline(eye(), step_deg), Error);
  ViewSpec buried = eye();
  buried.eye_map->z = 90;
  CHECK_THROWS_AS(session.skyline(buried), Error);
  CHECK(session.sights(eye(), {}).empty());
}

} // namespace orograph::library_look_around_test
