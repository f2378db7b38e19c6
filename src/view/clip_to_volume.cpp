// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/clip_to_volume.hpp"

#include "geometry/clip_by_planes.hpp"

#include <cmath>

namespace orograph {
namespace {

// Left, right, below, above, back, front. That w >= 0 follows from back and front.
PlaneValues plane_values(const Eigen::Vector4d& p, const CanonicalVolume& volume) {
  const double x = p.x(), y = p.y(), z = p.z(), w = p.w();
  if (volume.projection == PhigsProjection::parallel)
    return {w + x, w - x, w + y, w - y, w + z, -z};
  return {x - z, -z - x, y - z, -z - y, w + z, std::fma(volume.z_min, w, -z)};
}

// From the nearer end, so that ends stay what they are.
Eigen::Vector4d point_at(const Eigen::Vector4d& from, const Eigen::Vector4d& to, double t) {
  if (t <= 0.5) return from + t * (to - from);
  return to - (1 - t) * (to - from);
}

} // namespace

std::optional<AcceptedPart> clip_to_volume(const Eigen::Vector4d& from, const Eigen::Vector4d& to,
                                           const CanonicalVolume& volume) {
  const auto shares = clip_by_planes(plane_values(from, volume), plane_values(to, volume));
  if (!shares) return std::nullopt;
  const auto [begin, end] = *shares;
  return AcceptedPart{begin, end, point_at(from, to, begin), point_at(from, to, end)};
}

} // namespace orograph
