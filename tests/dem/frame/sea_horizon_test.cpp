// SPDX-License-Identifier: GPL-3.0-or-later
// The dip of the sea horizon: brute force over places of a lattice against closed forms.
#include "dem/frame/earth_lattice.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace orograph::sea_horizon_test {
namespace {

constexpr std::array kEyeHeights_m{2., 10., 100., 1000., 3000., 9000.};
const Ellipsoid kSphere{6371000, 0};

double elevation_rad(Vec3 place_m, double eye_height_m) {
  return std::atan2(place_m.z - eye_height_m, std::hypot(place_m.x, place_m.y));
}

// The places of the sea at the eye's level of longitude and latitude, from a tenth of the horizon's
// distance to twice it, in a line that leaves along the meridian or along the parallel.
std::vector<Vec3> line_of_sea(const LocalFrame& frame, bool along_meridian, double eye_height_m) {
  const double reach_deg = 2 * std::sqrt(2 * eye_height_m / 6371000) * 180 / 3.141592653589793;
  const int count = 8000;
  const double lon = frame.origin_lon_deg(), lat = frame.origin_lat_deg();
  DegreeLattice line{lon, 0, 1, lat, 0, 1};
  if (along_meridian) {
    line.lat_step_deg = reach_deg / count;
    line.first_lat_deg += reach_deg / 10;
    line.rows = count;
  } else {
    line.lon_step_deg = reach_deg / count / cos(Angle::degrees(lat));
    line.first_lon_deg += reach_deg / 10;
    line.columns = count;
  }
  const EarthLattice places(line, frame);
  std::vector<Vec3> sea;
  for (int k = 0; k < count; ++k)
    sea.push_back(along_meridian ? places.vertex_m(0, k, 0) : places.vertex_m(k, 0, 0));
  return sea;
}

double highest_rad(const std::vector<Vec3>& sea, double eye_height_m, double coefficient,
                   double radius_m) {
  double highest = -1;
  for (Vec3 place_m : sea) {
    place_m.z += coefficient * (place_m.x * place_m.x + place_m.y * place_m.y) / (2 * radius_m);
    highest = std::max(highest, elevation_rad(place_m, eye_height_m));
  }
  return highest;
}

double degrees(double rad) {
  return rad * 180 / 3.141592653589793;
}

// The slope (up over level) at which a level direction's upright plane touches the ellipsoid:
// there the quadratic in the distance along a ray has a double root.
double tangent_slope(const LocalFrame& frame, Vec2 level, double eye_height_m) {
  const double a = frame.ellipsoid().semi_major_axis_m;
  const double b = a * (1 - frame.ellipsoid().flattening());
  const double s = sin(Angle::degrees(frame.origin_lat_deg()));
  const double c = cos(Angle::degrees(frame.origin_lat_deg()));
  const double n = a * a / std::hypot(a * c, b * s);
  // Over the origin's meridian: outward, east, along the axis; scaled to the unit sphere.
  const Vec3 eye{(n + eye_height_m) * c / a, 0, (n * b * b / (a * a) + eye_height_m) * s / b};
  const Vec3 up{c / a, 0, s / b};
  const Vec3 ahead{-level.y * s / a, level.x / a, level.y * c / b};
  // (eye·d)^2 = (d·d) (eye·eye - 1) with d = ahead + slope * up.
  const double over = dot(eye, eye) - 1;
  const double p = dot(eye, up) * dot(eye, up) - over * dot(up, up);
  const double q = dot(eye, up) * dot(eye, ahead) - over * dot(up, ahead);
  const double r = dot(eye, ahead) * dot(eye, ahead) - over * dot(ahead, ahead);
  return (-q - std::sqrt(q * q - p * r)) / p;
}

} // namespace

TEST_CASE("the sea horizon dips by acos(R / (R + h)) on a sphere") {
  for (const double lat_deg : {0.0, 47.3, -72.0})
    for (const double height_m : kEyeHeights_m)
      for (const bool along_meridian : {true, false}) {
        const LocalFrame frame(179.99, lat_deg, kSphere);
        const double dip = std::acos(6371000 / (6371000 + height_m));
        const double found =
            highest_rad(line_of_sea(frame, along_meridian, height_m), height_m, 0, 6371000);
        CAPTURE(lat_deg, height_m, along_meridian, degrees(dip), degrees(found));
        CHECK(found <= -dip + 1e-12); // no place of the sea above the tangent
        CHECK(std::abs(found + dip) <= 1e-6 * dip);
      }
}

TEST_CASE("3.0437 degrees at 9 km without refraction") {
  const double found =
      highest_rad(line_of_sea(LocalFrame(7, 46, kSphere), true, 9000), 9000, 0, 6371000);
  CHECK(std::abs(degrees(found) + 3.0437) <= 5e-5);
}

TEST_CASE("on the ellipsoid no sea rises above the tangent of its azimuth, and some reaches it") {
  Random random(1);
  for (const double lat_deg : {0.0, 44.27, -83.0})
    for (const double height_m : kEyeHeights_m) {
      const LocalFrame frame(-71.3, lat_deg);
      const double reach_deg = degrees(2 * std::sqrt(2 * height_m / 6371000));
      const double wide_deg = reach_deg / cos(Angle::degrees(std::abs(lat_deg) + reach_deg));
      const int count = 151;
      const EarthLattice places({-71.3 - wide_deg, 2 * wide_deg / (count - 1), count,
                                 lat_deg + reach_deg, -2 * reach_deg / (count - 1), count},
                                frame);
      const double dip = std::sqrt(2 * height_m / 6371000);
      double lowest = 1;
      std::array<double, 16> closest; // below the tangent, as a share of the dip, by azimuth
      closest.fill(1);
      for (int row = 0; row < count; ++row)
        for (int column = 0; column < count; ++column) {
          if (row == count / 2 && column == count / 2) continue; // under the eye
          const Vec3 at = places.vertex_m(column, row, 0);
          const double level_m = std::hypot(at.x, at.y);
          const double below = (tangent_slope(frame, {at.x / level_m, at.y / level_m}, height_m) -
                                (at.z - height_m) / level_m) /
                               dip;
          lowest = std::min(lowest, below);
          const double turn = degrees(std::atan2(at.x, at.y)) + 180;
          double& sector = closest[static_cast<std::size_t>(std::min(turn / 22.5, 15.))];
          sector = std::min(sector, below);
        }
      CAPTURE(lat_deg, height_m);
      CHECK(lowest >= -1e-7);
      for (const double below : closest) CHECK(below <= 1e-3);
    }
}

TEST_CASE("refraction makes the dip that of an earth flatter by 1 - K") {
  // sqrt(2 h (1 - K) / R) leaves out terms of h / R: 0.14 % at 9 km.
  for (const double coefficient : {0.0, 0.13, 1. / 7, 0.25, -0.1})
    for (const double height_m : kEyeHeights_m) {
      const LocalFrame frame(7, 46, kSphere);
      const double found = highest_rad(line_of_sea(frame, true, height_m), height_m, coefficient,
                                       mean_radius_m(kSphere, 46));
      const double dip = std::sqrt(2 * height_m * (1 - coefficient) / 6371000);
      CAPTURE(coefficient, height_m, degrees(dip), degrees(found));
      CHECK(std::abs(found + dip) <= (1e-6 + height_m / 6371000) * dip);
    }
}

} // namespace orograph::sea_horizon_test
