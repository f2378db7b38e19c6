// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/angle.hpp"

#include <numbers>

namespace orograph {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

struct SinCos {
  double sin, cos;
};

// remquo brings the angle to [-45, 45] degrees without rounding, so that only the small remainder
// meets pi; the quadrant then swaps and negates.
SinCos sin_cos(Angle a) {
  int quadrant = 0;
  const double rest = std::remquo(a.in_degrees(), 90.0, &quadrant) * kRadiansPerDegree;
  const double s = std::sin(rest), c = std::cos(rest);
  switch (static_cast<unsigned>(quadrant) & 3U) {
  case 0:
    return {s, c};
  case 1:
    return {c, 0 - s};
  case 2:
    return {0 - s, 0 - c};
  default:
    return {0 - c, s};
  }
}

} // namespace

double Angle::in_radians() const {
  return deg_ * kRadiansPerDegree;
}

double sin(Angle a) {
  return sin_cos(a).sin;
}
double cos(Angle a) {
  return sin_cos(a).cos;
}
double tan(Angle a) {
  const auto [s, c] = sin_cos(a);
  return s / c;
}

Angle atan2_angle(double y, double x) {
  if (y == 0) return Angle::degrees(x < 0 ? 180 : 0);
  if (x == 0) return Angle::degrees(y < 0 ? -90 : 90);
  return Angle::degrees(std::atan2(y, x) / kRadiansPerDegree);
}

double azimuth_deg(Vec2 direction) {
  const double deg = atan2_angle(direction.x, direction.y).in_degrees();
  return deg < 0 ? deg + 360 : deg;
}

Vec2 direction_of_azimuth(Angle azimuth) {
  return {sin(azimuth), cos(azimuth)};
}

} // namespace orograph
