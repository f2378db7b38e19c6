// SPDX-License-Identifier: GPL-3.0-or-later
// Clipping an edge by the six planes of a view volume.
#pragma once

#include <array>
#include <optional>

namespace orograph {

constexpr unsigned kVolumePlanes = 6;

/// For each plane a function that is linear along an edge and not negative on the volume's side, at
/// one of its ends.
using PlaneValues = std::array<double, kVolumePlanes>;

/// What of an edge is inside, as shares of the way from its beginning to its end. It may be a
/// single point.
struct SharesInside {
  double begin = 0, end = 1;
};

/// Cohen and Sutherland's method: ends outside are moved to a plane that they are outside of, until
/// an outcode says that all or nothing is left. After each move it asks again whether both ends are
/// outside one plane, so an edge that misses a corner is rejected. (Chen and Sabbagh 1983, section
/// 5.7, which does not ask again.) A point on a plane is inside.
///
/// Shares are right to some 1e-16, since differences are taken of values of opposite signs only. So
/// an edge is accepted or rejected rightly unless it passes an edge of the volume within rounding.
/// REQUIRES finite values.
std::optional<SharesInside> clip_by_planes(const PlaneValues& from, const PlaneValues& to);

} // namespace orograph
