// SPDX-License-Identifier: GPL-3.0-or-later
// The cut of a TIN by its definition: every triangle's section by the plane, on its own, in long
// double.
#pragma once

#include "dem/tin.hpp"
#include "geometry/profile_point.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orograph {

struct ExactPoint {
  long double u, v, z;
};

/// A triangle's part of the plane, from left to right.
struct TinSection {
  std::size_t triangle;
  ExactPoint left, right;
  bool in_plane, in_front; ///< an edge that lies in the plane; of a triangle in front of it
};

/// What the triangles say of one view and plane. Positions in the profile frame are rounded, as
/// they have to be, and from there on taken as exact.
class TinSections {
public:
  TinSections(const Tin& tin, const View& view, double depth) : tin_(tin), depth_(depth) {
    for (const Vec3& vertex : tin.vertices_m) {
      const ProfilePoint p = to_profile_frame(view, vertex);
      points_.push_back({p.u, p.v, p.z});
    }
    for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
      const auto& [a, b, c] = tin.triangles[t];
      const Vec3 p = tin.vertices_m[a], q = tin.vertices_m[b], r = tin.vertices_m[c];
      const long double one = static_cast<long double>(q.x - p.x) * (r.y - p.y),
                        other = static_cast<long double>(q.y - p.y) * (r.x - p.x);
      const bool wall = std::abs(one - other) <= 1e-14L * (std::abs(one) + std::abs(other));
      cut(t, depth, wall ? walls : ground);
    }
  }

  std::vector<TinSection> ground, walls;

  bool passes_beside_vertex(long double slack) const {
    return std::any_of(points_.begin(), points_.end(), [&](const ExactPoint& p) {
      return p.v != depth_ && std::abs(p.v - depth_) <= slack;
    });
  }

  // Normal times direction to the eye over the sum of its terms' sizes.
  long double facing(const View& view, std::size_t t) const {
    const auto& corners = tin_.triangles[t];
    const ExactPoint &a = points_[corners[0]], &b = points_[corners[1]], &c = points_[corners[2]];
    const ExactPoint p{b.u - a.u, b.v - a.v, b.z - a.z}, q{c.u - a.u, c.v - a.v, c.z - a.z};
    const ExactPoint eye = view.is_perspective() ? ExactPoint{-a.u, -a.v, view.eye_z_m - a.z}
                                                 : ExactPoint{0, -view.y_per_z, view.y_per_v};
    const long double x = eye.u * (p.v * q.z - p.z * q.v), y = eye.v * (p.z * q.u - p.u * q.z),
                      z = eye.z * (p.u * q.v - p.v * q.u);
    const long double size = std::abs(x) + std::abs(y) + std::abs(z);
    return size > 0 ? (x + y + z) / size : 0;
  }

private:
  void cut(std::size_t t, long double depth, std::vector<TinSection>& out) const {
    std::vector<ExactPoint> met;
    long double nearest = HUGE_VALL;
    int on_plane = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const ExactPoint &a = points_[tin_.triangles[t][k]],
                       &b = points_[tin_.triangles[t][(k + 1) % 3]];
      nearest = std::min(nearest, a.v);
      if (a.v == depth) {
        met.push_back(a);
        ++on_plane;
      } else if ((a.v < depth && b.v > depth) || (a.v > depth && b.v < depth)) {
        const long double s = (depth - a.v) / (b.v - a.v);
        met.push_back({a.u + s * (b.u - a.u), depth, a.z + s * (b.z - a.z)});
      }
    }
    if (met.size() < 2) return; // not met, or touched in a vertex
    const auto [left, right] = std::minmax_element(
        met.begin(), met.end(), [](const ExactPoint& a, const ExactPoint& b) { return a.u < b.u; });
    // Upright, the minimum and the maximum of u are one.
    if (left->u == right->u)
      out.push_back({t, met[0], met[1], on_plane >= 2, nearest < depth});
    else
      out.push_back({t, *left, *right, on_plane >= 2, nearest < depth});
  }

  const Tin& tin_;
  long double depth_;
  std::vector<ExactPoint> points_;
};

} // namespace orograph
