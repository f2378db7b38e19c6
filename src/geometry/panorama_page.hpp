// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a panorama: azimuths to the right, altitudes upwards (docs/panoramas.md).
#pragma once

#include "geometry/profile_point.hpp"
#include "geometry/vec.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace orograph {

/// What is upwards: the tangent of the altitude, as on a cylinder about the eye, or the altitude.
enum class PanoramaKind { cylindrical, equirectangular };

/// Maps points of a profile frame under the eye to page millimetres, y down. A radian of azimuth is
/// `radius_mm` wide, and on the horizon a radian of altitude as high.
struct PanoramaPage {
  PanoramaKind kind = PanoramaKind::cylindrical;
  double radius_mm = 1;
  Vec2 ahead_mm;      ///< of the frame's forward direction, at the eye's own height
  double eye_z_m = 0; ///< in the frame

  /// Clockwise from the forward direction, from -pi to pi.
  static double azimuth(ProfilePoint p) { return std::atan2(p.u + 0.0, p.v); } // no -0
  double tangent(ProfilePoint p) const {
    return (p.z - eye_z_m) / std::sqrt(p.u * p.u + p.v * p.v);
  }
  double x_mm(double azimuth) const { return ahead_mm.x + radius_mm * azimuth; }
  double y_mm(double tangent) const {
    return ahead_mm.y -
           radius_mm * (kind == PanoramaKind::cylindrical ? tangent : std::atan(tangent));
  }
  Vec2 operator()(ProfilePoint p) const { return {x_mm(azimuth(p)), y_mm(tangent(p))}; }

  /// Where the straight line from a to b is as high or as low as a tangent, as shares of its way,
  /// rising; NaN where it isn't, or not twice. Some may be beyond its ends.
  std::array<double, 2> crossings(ProfilePoint a, ProfilePoint b, double tangent) const {
    const double up = a.z - eye_z_m, square = tangent * tangent;
    const ProfilePoint way{b.u - a.u, b.v - a.v, b.z - a.z};
    const double second = way.z * way.z - square * (way.u * way.u + way.v * way.v),
                 first = up * way.z - square * (a.u * way.u + a.v * way.v),
                 none = up * up - square * (a.u * a.u + a.v * a.v);
    const double root = std::sqrt(first * first - second * none);
    const double larger = -first - std::copysign(root, first);
    const double one = larger / second, other = none / larger;
    return {std::min(one, other), std::max(one, other)};
  }
  /// Length on the page of a small step from p, over the step's.
  double mm_per_step(ProfilePoint p, Vec3 step) const {
    const double square = p.u * p.u + p.v * p.v, away = std::sqrt(square), up = p.z - eye_z_m;
    const double turned = (p.v * step.x - p.u * step.y) / square;
    const double raised = step.z / away - up * (p.u * step.x + p.v * step.y) / (square * away);
    const double of_altitude = kind == PanoramaKind::cylindrical ? 1 : square / (square + up * up);
    return radius_mm * std::hypot(turned, of_altitude * raised);
  }
};

/// Where the straight line from a to b crosses the plane straight behind the eye, in which the page
/// is cut open: the share of its way. None where it doesn't. A point in that plane is on the right.
inline std::optional<double> seam_crossing(ProfilePoint a, ProfilePoint b) {
  if ((a.u >= 0) == (b.u >= 0)) return std::nullopt;
  const double share = a.u / (a.u - b.u);
  if (!(a.v + share * (b.v - a.v) < 0)) return std::nullopt;
  return share;
}

} // namespace orograph
