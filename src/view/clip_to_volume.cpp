// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: a plane's function is >= 0 on the volume's side. Where its values a and b at an edge's
// ends differ in sign, the edge crosses the plane at t = a / (a - b).
#include "view/clip_to_volume.hpp"

#include <array>
#include <bit>
#include <cmath>

namespace orograph {
namespace {

constexpr unsigned kPlanes = 6;
using PlaneValues = std::array<double, kPlanes>;

// Left, right, below, above, back, front. That w >= 0 follows from back and front.
PlaneValues plane_values(const Eigen::Vector4d& p, const CanonicalVolume& volume) {
  const double x = p.x(), y = p.y(), z = p.z(), w = p.w();
  if (volume.projection == PhigsProjection::parallel)
    return {w + x, w - x, w + y, w - y, w + z, -z};
  return {x - z, -z - x, y - z, -z - y, w + z, std::fma(volume.z_min, w, -z)};
}

// The shares t of an edge that are inside a plane: first <= t <= last.
struct Inside {
  double first, last;
};
using EdgeInside = std::array<Inside, kPlanes>;

Inside inside(double from, double to) {
  if (from < 0 && to < 0) return {2, -1}; // none
  if (from < 0) return {from / (from - to), 1};
  if (to < 0) return {0, from / (from - to)};
  return {0, 1};
}

// Bit i is set where the edge's point at t is outside plane i. Told by t and not by the point, so
// that what was moved to a plane is no longer outside it.
unsigned outcode(const EdgeInside& edge, double t) {
  unsigned code = 0;
  for (unsigned plane = 0; plane < kPlanes; ++plane)
    if (t < edge[plane].first || t > edge[plane].last) code |= 1U << plane;
  return code;
}

// From the nearer end, so that ends stay what they are.
Eigen::Vector4d point_at(const Eigen::Vector4d& from, const Eigen::Vector4d& to, double t) {
  if (t <= 0.5) return from + t * (to - from);
  return to - (1 - t) * (to - from);
}

} // namespace

std::optional<AcceptedPart> clip_to_volume(const Eigen::Vector4d& from, const Eigen::Vector4d& to,
                                           const CanonicalVolume& volume) {
  const PlaneValues from_values = plane_values(from, volume), to_values = plane_values(to, volume);
  EdgeInside edge;
  for (unsigned plane = 0; plane < kPlanes; ++plane)
    edge[plane] = inside(from_values[plane], to_values[plane]);

  double t_begin = 0, t_end = 1;
  unsigned begin_code = outcode(edge, t_begin), end_code = outcode(edge, t_end);
  // An end that is outside a plane which the other end is not outside of has a crossing with it
  // further in, so each move clears a bit for good.
  while ((begin_code & end_code) == 0) {
    if (begin_code != 0) {
      t_begin = edge[std::countr_zero(begin_code)].first;
      begin_code = outcode(edge, t_begin);
    } else if (end_code != 0) {
      t_end = edge[std::countr_zero(end_code)].last;
      end_code = outcode(edge, t_end);
    } else {
      return AcceptedPart{t_begin, t_end, point_at(from, to, t_begin), point_at(from, to, t_end)};
    }
  }
  return std::nullopt;
}

} // namespace orograph
