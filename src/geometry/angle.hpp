// SPDX-License-Identifier: GPL-3.0-or-later
// Angles that know their unit, with sines and cosines exact at multiples of 90 degrees, so that a
// view along the grid is along the grid and a view from 90 degrees is a plan, to the last bit.
#pragma once

#include "geometry/api.hpp"
#include "geometry/vec.hpp"

namespace orograph {

class Angle {
public:
  constexpr Angle() = default;
  static constexpr Angle degrees(double deg) { return Angle(deg); }
  constexpr double in_degrees() const { return deg_; }
  OROGRAPH_API double in_radians() const;
  constexpr auto operator<=>(const Angle&) const = default;

private:
  explicit constexpr Angle(double deg) : deg_(deg) {}
  double deg_ = 0;
};

constexpr Angle operator-(Angle a) {
  return Angle::degrees(-a.in_degrees());
}
constexpr Angle operator+(Angle a, Angle b) {
  return Angle::degrees(a.in_degrees() + b.in_degrees());
}
constexpr Angle operator*(double s, Angle a) {
  return Angle::degrees(s * a.in_degrees());
}

/// Exact (0, 1, -1) at multiples of 90 degrees; elsewhere right to 1 ulp of the reduced angle.
OROGRAPH_API double sin(Angle a);
OROGRAPH_API double cos(Angle a);
OROGRAPH_API double tan(Angle a);
/// Angle of the vector (x, y) from the x axis, in (-180, 180] degrees; exact on the axes.
OROGRAPH_API Angle atan2_angle(double y, double x);
/// Of a direction in the plane, clockwise from y, in [0, 360); exact on the axes.
OROGRAPH_API double azimuth_deg(Vec2 direction);

/// Unit vector (east, north) of an azimuth, clockwise from north.
OROGRAPH_API Vec2 direction_of_azimuth(Angle azimuth);

} // namespace orograph
