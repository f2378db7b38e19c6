// SPDX-License-Identifier: GPL-3.0-or-later
// Radii of curvature against GeographicLib's, and against the drop of the ellipsoid itself.
#include "dem/frame/local_frame.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <GeographicLib/Ellipsoid.hpp>

#include <cmath>
#include <limits>

using namespace orograph;

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
