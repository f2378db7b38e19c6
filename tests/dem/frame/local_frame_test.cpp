// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of single places against GeographicLib, and against what its words say.
#include "dem/frame/local_frame.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <GeographicLib/Ellipsoid.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/LocalCartesian.hpp>

#include <cmath>
#include <limits>

namespace orograph::local_frame_test {
TEST_CASE("places in the frame are LocalCartesian's, and come back") {
  Random random(1);
  double worst_deg = 0, worst_m = 0;
  for (int i = 0; i < 10000; ++i) {
    const double lon0_deg = random.between(-540, 540), lat0_deg = random.between(-88, 88);
    const LocalFrame frame(lon0_deg, lat0_deg);
    // Within a few hundred kilometres, in any turn.
    const GeoPoint point{lon0_deg + random.between(-3, 3) + 360 * random.whole(-2, 2),
                         lat0_deg + random.between(-2, 2), random.between(-500, 9000)};
    CAPTURE(lon0_deg, lat0_deg, point.lon_deg, point.lat_deg, point.h_m);
    Vec3 theirs_m;
    GeographicLib::LocalCartesian(lat0_deg, lon0_deg)
        .Forward(point.lat_deg, point.lon_deg, point.h_m, theirs_m.x, theirs_m.y, theirs_m.z);
    const Vec3 ours_m = frame.to_frame(point.lon_deg, point.lat_deg, point.h_m);
    REQUIRE(ours_m == theirs_m);

    const GeoPoint back = frame.to_geodetic(ours_m);
    REQUIRE(std::abs(back.lon_deg - lon0_deg) <= 180);
    worst_deg = std::max({worst_deg, std::abs(back.lat_deg - point.lat_deg),
                          std::abs(std::remainder(back.lon_deg - point.lon_deg, 360))});
    worst_m = std::max(worst_m, std::abs(back.h_m - point.h_m));
  }
  INFO("worst: " << worst_deg << " degrees, " << worst_m << " m of height");
  CHECK(worst_deg <= 1e-9);
  CHECK(worst_m <= 1e-6);
}

TEST_CASE("what is above the origin is so exactly") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double lon_deg = random.between(-540, 540), lat_deg = random.between(-90, 90);
    const double height_m = random.between(-500, 9000);
    REQUIRE(LocalFrame(lon_deg, lat_deg).to_frame(lon_deg, lat_deg, height_m) ==
            Vec3{0, 0, height_m});
  }
}

TEST_CASE("east, north and up are those of the origin") {
  const LocalFrame frame(10, 46);
  CHECK(frame.to_frame(10, 46, 0) == Vec3{0, 0, 0});
  const Vec3 east = frame.to_frame(10.001, 46, 0), north = frame.to_frame(10, 46.001, 0);
  const Vec3 up = frame.to_frame(10, 46.0000000001, 100);
  // A minute of latitude is a nautical mile or so; of longitude, cos(46) of it.
  CHECK(north.y == Approx(111.15).epsilon(1e-3));
  CHECK(east.x == Approx(77.47).epsilon(1e-3));
  CHECK(std::abs(north.x) < 1e-8);
  CHECK(std::abs(east.y) < 1e-3);
  CHECK(std::abs(up.x) < 1e-8);
  CHECK(up.y == Approx(1.1115e-5).epsilon(0.01));
  CHECK(std::abs(up.z - 100) < 1e-8);
  // The sea falls away on all sides: 785 m at 100 km.
  CHECK(frame.to_frame(10, 46.9, 0).z == Approx(-785).epsilon(0.01));
  CHECK(frame.to_frame(10, 45.1, 0).z == Approx(-785).epsilon(0.01));
}

TEST_CASE("longitudes come back in the origin's turn") {
  for (const double origin_deg : {-180.0, 0.0, 179.5, 180.0, 359.9, 360.0, 719.0, -359.0})
    for (const double east_deg : {-0.4, 0.0, 0.3}) {
      const LocalFrame frame(origin_deg, -17);
      CAPTURE(origin_deg, east_deg);
      const Vec3 at_m = frame.to_frame(origin_deg + east_deg, -17, 0);
      CHECK(std::abs(frame.to_geodetic(at_m).lon_deg - (origin_deg + east_deg)) <= 1e-9);
    }
}

TEST_CASE("distances and azimuths are Geodesic::Inverse's") {
  Random random(3);
  for (const Ellipsoid ellipsoid : {Ellipsoid{}, Ellipsoid{6377397.155, 299.1528128}}) {
    const GeographicLib::Geodesic geodesic(ellipsoid.semi_major_axis_m, ellipsoid.flattening());
    for (int i = 0; i < 2000; ++i) {
      const GeoPoint from{random.between(-400, 400), random.between(-85, 85), 300};
      const double near = random.pick({1e-4, 1.0, 60.0});
      const GeoPoint to{from.lon_deg + random.between(-near, near),
                        std::clamp(from.lat_deg + random.between(-near, near), -90., 90.), 0};
      double distance_m = 0, azimuth_deg = 0, arrival_deg = 0;
      geodesic.Inverse(from.lat_deg, from.lon_deg, to.lat_deg, to.lon_deg, distance_m, azimuth_deg,
                       arrival_deg);
      const DistanceAzimuth ours = distance_and_azimuth(from, to, ellipsoid);
      REQUIRE(ours.distance_m == distance_m);
      REQUIRE(ours.azimuth.in_degrees() >= 0);
      REQUIRE(ours.azimuth.in_degrees() < 360);
      REQUIRE(std::abs(std::remainder(ours.azimuth.in_degrees() - azimuth_deg, 360)) <= 1e-13);
    }
  }
  // Clockwise from north, also across the antimeridian; a hair west of north isn't 360.
  CHECK(distance_and_azimuth({0, 0, 0}, {0, 1, 0}).azimuth.in_degrees() == 0);
  CHECK(distance_and_azimuth({179.9, 0, 0}, {-179.9, 0, 0}).azimuth.in_degrees() == Approx(90));
  CHECK(distance_and_azimuth({0, 10, 0}, {0, 9, 0}).azimuth.in_degrees() == Approx(180));
  CHECK(distance_and_azimuth({0, 0, 0}, {359, 0, 0}).azimuth.in_degrees() == Approx(270));
  for (const double west_deg : {1e-16, 1e-18}) {
    const double azimuth_deg =
        distance_and_azimuth({0, 0, 0}, {-west_deg, 1, 0}).azimuth.in_degrees();
    CHECK(azimuth_deg == 0);
    CHECK_FALSE(std::signbit(azimuth_deg));
  }
  // Its own known answer: a degree of the equator.
  CHECK(distance_and_azimuth({0, 0, 0}, {1, 0, 0}).distance_m == Approx(111319.4908).epsilon(1e-9));
}

TEST_CASE("no place on the ellipsoid: refused in a line") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double lat_deg : {90.001, -91.0, nan, infinity})
    CHECK_THROWS_AS(LocalFrame(0, lat_deg), Error);
  for (const double lon_deg : {nan, infinity}) CHECK_THROWS_AS(LocalFrame(lon_deg, 0), Error);
  // Latitude and longitude swapped, where it can be seen.
  CHECK_THROWS_WITH(LocalFrame(44.2, -122.5),
                    "no place at longitude 44.2, latitude -122.5 degrees: latitudes are within -90 "
                    "to 90; longitude comes first");
  CHECK_NOTHROW(LocalFrame(0, 90));
  CHECK(std::isnan(LocalFrame(0, 0).to_frame(0, 90.1, 0).x));
}

// Radii of curvature against GeographicLib's, and against the drop of the ellipsoid itself.

TEST_CASE("Euler's radius is GeographicLib's, and Gauss's is its mean over all azimuths") {
  Random random(1);
  for (const double inverse_flattening : {298.257223563, 293.4663077, 0.0, 20.0}) {
    const Ellipsoid ellipsoid{random.between(1e6, 1e7), inverse_flattening};
    const GeographicLib::Ellipsoid theirs(ellipsoid.semi_major_axis_m, ellipsoid.flattening());
    for (int i = 0; i < 500; ++i) {
      const double lat_deg = random.pick({0.0, 90.0, -90.0, random.between(-90, 90)});
      const double azimuth_deg = random.pick({0.0, 90.0, random.between(-720, 720)});
      CAPTURE(inverse_flattening, lat_deg, azimuth_deg);
      const double radius_m = theirs.NormalCurvatureRadius(lat_deg, azimuth_deg);
      CHECK(std::abs(euler_radius_m(ellipsoid, lat_deg, Angle::degrees(azimuth_deg)) - radius_m) <=
            1e-14 * radius_m);

      double sum_m = 0;
      for (int k = 0; k < 64; ++k)
        sum_m += theirs.NormalCurvatureRadius(lat_deg, azimuth_deg + k * 360 / 64.);
      CHECK(std::abs(mean_radius_m(ellipsoid, lat_deg) - sum_m / 64) <= 1e-13 * radius_m);
    }
  }
}

TEST_CASE("the ellipsoid drops by d^2 / 2R, R Euler's radius in the azimuth") {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const double lat_deg = random.between(-80, 80);
    const LocalFrame frame(12, lat_deg);
    const GeoPoint near{12 + random.between(-0.05, 0.05), lat_deg + random.between(-0.02, 0.02), 0};
    const Vec3 at_m = frame.to_frame(near.lon_deg, near.lat_deg, 0);
    const Angle azimuth = atan2_angle(at_m.x, at_m.y);
    const double drop_m =
        (at_m.x * at_m.x + at_m.y * at_m.y) / (2 * euler_radius_m({}, lat_deg, azimuth));
    CAPTURE(lat_deg, azimuth.in_degrees(), drop_m);
    // Within the next term of the series, d / R of it, and the nanometres that the places have.
    CHECK(std::abs(-at_m.z - drop_m) <= 1e-2 * 2.5e-3 * drop_m + 3e-9);
  }
}

TEST_CASE("no ellipsoid: refused in a line") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double axis_m : {0.0, -1.0, nan, infinity}) {
    CHECK_THROWS_AS(check({axis_m, 300}), Error);
    CHECK_THROWS_AS(LocalFrame(0, 0, {axis_m, 300}), Error);
    CHECK_THROWS_AS(distance_and_azimuth({}, {}, {axis_m, 300}), Error);
  }
  for (const double inverse_flattening : {1.0, 0.5, 1 / 298.257, -300.0, nan, infinity})
    CHECK_THROWS_AS(check({6378137, inverse_flattening}), Error);
  CHECK_NOTHROW(check({}));
  CHECK_NOTHROW(check({6371000, 0}));
}

} // namespace orograph::local_frame_test
