// SPDX-License-Identifier: GPL-3.0-or-later
// Longitude and latitude against formulas that hold exactly, and round trips.
#include "dem/read/crs_frame.hpp"
#include "dem/read/lonlat.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace orograph::lonlat_test {
namespace {

constexpr double kRadian = std::numbers::pi / 180;
constexpr double a_m = 6378137, f = 1 / 298.257223563, e2 = f * (2 - f); // WGS 84

// From the equator along a meridian: Simpson's rule on the radius of curvature.
double meridian_arc_m(double latitude_deg) {
  constexpr int kSteps = 2000; // even
  const double step = latitude_deg * kRadian / kSteps;
  double sum = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double s = std::sin(i * step);
    const int weight = i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * a_m * (1 - e2) / std::pow(1 - e2 * s * s, 1.5);
  }
  return sum * step / 3;
}

double apart(Angle a, double deg) {
  return std::abs(std::remainder(a.in_degrees() - deg, 360));
}

Vec2 on_map(const std::string& crs, Vec2 lonlat) {
  const auto place = map_of_lonlat(crs, lonlat);
  REQUIRE(place);
  return *place;
}

} // namespace

TEST_CASE("on the central meridian of UTM, northing is the meridian's arc times 0.9996") {
  for (const double latitude : {-79.5, -30.0, 0.0, 1e-6, 12.25, 47.0, 83.9}) {
    INFO("latitude " << latitude);
    const Vec2 place = on_map("EPSG:32632", {9, latitude});
    CHECK(std::abs(place.x - 500000) <= 1e-6);
    CHECK(std::abs(place.y - 0.9996 * meridian_arc_m(latitude)) <= 1e-6);
  }
  // As other programs have it.
  CHECK(std::abs(on_map("EPSG:32632", {9, 47}).y - 5205164.110) <= 1e-3);
  const Vec2 aside = on_map("EPSG:32632", {11, 47.5});
  CHECK(std::abs(aside.x - 650624.231) <= 1e-3);
  CHECK(std::abs(aside.y - 5262668.332) <= 1e-3);
}

TEST_CASE("eastings come first whatever the order of axes, in the CRS's own unit") {
  CHECK(std::abs(on_map("EPSG:2193", {173, -41}).x - 1600000) <= 1e-3);    // northing first
  CHECK(std::abs(on_map("EPSG:32632", {9 - 360, 47}).x - 500000) <= 1e-6); // a turn apart
  CHECK(std::abs(on_map("EPSG:32632", {9 + 360, 47}).x - 500000) <= 1e-6);
  const Vec2 feet = on_map("EPSG:2229", {-118, 34}), metres = on_map("EPSG:26945", {-118, 34});
  CHECK(std::abs(feet.x * 1200 / 3937 - metres.x) <= 1e-3);
  CHECK(std::abs(feet.y * 1200 / 3937 - metres.y) <= 1e-3);
  const Vec2 degrees = on_map("EPSG:4326", {9, 47}); // latitude first
  CHECK(std::abs(degrees.x - 9) <= 1e-12);
  CHECK(std::abs(degrees.y - 47) <= 1e-12);
}

TEST_CASE("heights take no part") {
  const Vec2 plane = on_map("EPSG:32632", {10.5, 46});
  CHECK(on_map("EPSG:32632+5773", {10.5, 46}) == plane);
  const Crs solid = crs_from_text("EPSG:32632");
  solid->PromoteTo3D(nullptr);
  char* text = nullptr;
  const std::array<const char*, 2> options{"FORMAT=WKT2_2018", nullptr};
  solid->exportToWkt(&text, options.data());
  CHECK(on_map(text, {10.5, 46}) == plane);
  CPLFree(text);
}

TEST_CASE("there and back again") {
  struct Area {
    const char* crs;
    Vec2 low, high;
    double off_deg = 1e-9;
  };
  // Between two datums, there and back are as good as series, some millimetres; where PROJ has one
  // shift for a country and others for its parts, it may take the one there and the other back.
  for (const auto& [crs, low, high, off_deg] :
       {Area{"EPSG:32632", {6, -80}, {12, 84}}, Area{"EPSG:31287", {9.5, 46.4}, {17.2, 49}, 2e-5},
        Area{"EPSG:27700", {-7, 50}, {1.5, 60}, 3e-8},
        Area{"EPSG:2193", {166.5, -47}, {178.5, -34}}, Area{"EPSG:3031", {-179, -89.5}, {179, -61}},
        Area{"EPSG:2229", {-121, 33}, {-114, 35.8}}, Area{"EPSG:32601", {-180, 0}, {-174, 80}},
        Area{"EPSG:4326", {-179.9, -90}, {179.9, 90}}}) {
    Random random(7);
    for (int i = 0; i < 20; ++i) {
      const Vec2 lonlat{random.between(low.x, high.x), random.between(low.y, high.y)};
      CAPTURE(crs, lonlat.x, lonlat.y);
      const auto back = lonlat_of_map(crs, on_map(crs, lonlat));
      REQUIRE(back);
      CHECK(std::abs(std::remainder(back->x - lonlat.x, 360)) <= off_deg);
      CHECK(std::abs(back->y - lonlat.y) <= off_deg);
    }
  }
}

TEST_CASE("no place where there is none") {
  const std::string local = "LOCAL_CS[\"a quarry\",UNIT[\"metre\",1]]";
  for (const std::string& crs : {std::string(), local, std::string("no CRS")}) {
    INFO(crs);
    CHECK_FALSE(is_on_earth(crs));
    CHECK_FALSE(lonlat_of_map(crs, {0, 0}));
    CHECK_FALSE(map_of_lonlat(crs, {0, 0}));
    CHECK_FALSE(lonlat_bounds(crs, {{0, 0}, {1, 1}}));
    CHECK_FALSE(map_azimuth(crs, {0, 0}, {}));
    CHECK_FALSE(true_azimuth(crs, {0, 0}, {}));
  }
  CHECK(is_on_earth("EPSG:32632"));
  CHECK(is_on_earth("EPSG:4326"));
  CHECK_FALSE(map_of_lonlat("EPSG:32632", {-81, 3}));
  CHECK_FALSE(lonlat_of_map("EPSG:32632", {1e12, 5e6}));
}

TEST_CASE("bounds hold the whole box, and go on across 180 degrees") {
  struct Area {
    const char* crs;
    Box2 map;
  };
  for (const auto& [crs, map] : {Area{"EPSG:32632", {{300000, 5e6}, {700000, 5.4e6}}},
                                 Area{"EPSG:32601", {{280000, 6.6e6}, {380000, 6.7e6}}},
                                 Area{"EPSG:27700", {{0, 0}, {6e5, 1e6}}}}) {
    INFO(crs);
    const auto bounds = lonlat_bounds(crs, map);
    REQUIRE(bounds);
    CHECK(bounds->width() < 12);
    Random random(3);
    Box2 met;
    for (int i = 0; i < 40; ++i) {
      const Vec2 p{random.chance(0.5) ? random.pick({map.low.x, map.high.x})
                                      : random.between(map.low.x, map.high.x),
                   random.chance(0.5) ? random.pick({map.low.y, map.high.y})
                                      : random.between(map.low.y, map.high.y)};
      const Vec2 at = lonlat_of_map(crs, p).value();
      const double x = bounds->low.x + std::remainder(at.x - bounds->low.x, 360);
      met.include({x, at.y});
    }
    // Between the points of its sides a box may bulge by a little.
    const double slack = 0.002 * std::max(bounds->width(), bounds->height());
    CHECK(met.low.x >= bounds->low.x - slack);
    CHECK(met.low.y >= bounds->low.y - slack);
    CHECK(met.high.x <= bounds->high.x + slack);
    CHECK(met.high.y <= bounds->high.y + slack);
    CHECK(met.low.x <= bounds->low.x + 0.1 * bounds->width());
    CHECK(met.high.y >= bounds->high.y - 0.1 * bounds->height());
  }
  const Box2 across = lonlat_bounds("EPSG:32601", {{280000, 6.6e6}, {380000, 6.7e6}}).value();
  CHECK(std::max(std::abs(across.low.x), std::abs(across.high.x)) > 180);
}

TEST_CASE("true north is aside of the map's by the convergence of meridians") {
  struct Map {
    const char* crs;
    double longitude, turn_per_degree, low, high;
  };
  // Conformal maps, on which the convergence is proportional to longitude, whatever the latitude:
  // a cone (the sine of its parallel) and the two polar planes.
  const Map maps[] = {
      {"+proj=lcc +lat_1=45 +lat_0=45 +lon_0=10 +datum=WGS84", 10, std::sin(45 * kRadian), 30, 60},
      {"EPSG:32661", 0, 1, 60, 89.9},
      {"EPSG:32761", 0, -1, -89.9, -60}};
  Random random(11);
  for (const auto& [crs, longitude, turn_per_degree, low, high] : maps)
    for (int i = 0; i < 40; ++i) {
      const Vec2 lonlat{longitude + random.between(-60, 60), random.between(low, high)};
      const double azimuth = random.pick({0.0, 90.0, 180.0, random.between(-180, 360)});
      CAPTURE(crs, lonlat.x, lonlat.y, azimuth);
      const Vec2 at = on_map(crs, lonlat);
      const auto turned = map_azimuth(crs, at, Angle::degrees(azimuth));
      REQUIRE(turned);
      CHECK(apart(*turned, azimuth - turn_per_degree * (lonlat.x - longitude)) <= 1e-7);
      const auto back = true_azimuth(crs, at, *turned);
      REQUIRE(back);
      CHECK(apart(*back, azimuth) <= 1e-7);
    }
}

TEST_CASE("on a map that isn't conformal, directions are those on the ground") {
  // Equal areas between 30 degrees north and south: wider by k than the ground, lower by 1/k.
  const std::string crs = "EPSG:6933";
  const auto circle_m = [](double latitude_deg) { // of a parallel, over that of the equator
    const double s = std::sin(latitude_deg * kRadian);
    return std::cos(latitude_deg * kRadian) / std::sqrt(1 - e2 * s * s);
  };
  Random random(5);
  for (int i = 0; i < 40; ++i) {
    const Vec2 lonlat{random.between(-170, 170), random.between(-70, 70)};
    const double azimuth = random.between(0, 360);
    CAPTURE(lonlat.x, lonlat.y, azimuth);
    const double k = circle_m(30) / circle_m(lonlat.y);
    const double expected =
        std::atan2(k * std::sin(azimuth * kRadian), std::cos(azimuth * kRadian) / k) / kRadian;
    const Vec2 at = on_map(crs, lonlat);
    const auto found = map_azimuth(crs, at, Angle::degrees(azimuth));
    REQUIRE(found);
    CHECK(apart(*found, expected) <= 1e-7);
    const auto back = true_azimuth(crs, at, *found);
    REQUIRE(back);
    CHECK(apart(*back, azimuth) <= 1e-7);
  }
}

} // namespace orograph::lonlat_test
