// SPDX-License-Identifier: GPL-3.0-or-later
// Clipping an edge to a canonical volume, in homogeneous coordinates.
#pragma once

#include "view/view_mapping.hpp"

#include <Eigen/Core>

#include <optional>

namespace orograph {

/// The part of an edge within the volume: from + t (to - from) for t_begin <= t <= t_end, with its
/// two ends. It may be a single point.
struct AcceptedPart {
  double t_begin = 0, t_end = 1;
  Eigen::Vector4d begin, end;
};

/// Cohen and Sutherland's method with the six planes of the volume (geometry/clip_by_planes.hpp).
///
/// x, y and z are over w, and the sign of w counts: a point with w < 0 is behind the eye and
/// outside, and an edge between w > 0 and w < 0 is that of the scene, whose picture runs to
/// infinity. What is accepted has w > 0. A point on a plane is inside, and which side of a plane an
/// end is on is decided exactly: every plane's function is a sum of two terms, rounded once.
/// REQUIRES finite coordinates; no point from `from` to `to` is (0, 0, 0, 0), as none is that a
/// regular matrix made of a scene's edge.
std::optional<AcceptedPart> clip_to_volume(const Eigen::Vector4d& from, const Eigen::Vector4d& to,
                                           const CanonicalVolume& volume);

} // namespace orograph
