// SPDX-License-Identifier: GPL-3.0-or-later
// From triangle to triangle along the ground line of a ray. A vertex is on the ray's left or on its
// right; the ray leaves a triangle over the edge between the two.
#include "profiles/ground_behind.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {

GroundBehindTin::GroundBehindTin(const Tin& tin, const View& view) : tin_(tin), view_(view) {
  begin_.assign(tin.vertices_m.size() + 1, 0);
  for (const auto& triangle : tin.triangles)
    for (const std::uint32_t vertex : triangle) ++begin_[vertex + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  triangles_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
    for (const std::uint32_t vertex : tin.triangles[t]) triangles_[next[vertex]++] = t;
}

bool GroundBehindTin::rises_within(SurfaceEdge edge, ProfilePoint from, double reach_m) const {
  // How far to the right of the ray a point is, in some measure.
  const auto right_of_ray = [&](ProfilePoint p) {
    return view_.is_perspective() ? p.u * from.v - from.u * p.v : p.u - from.u;
  };
  // Along the ray Y stays what it is.
  const double z_per_m = view_.is_perspective() ? (from.z - view_.eye_z_m) / from.v
                                                : -view_.sin_elevation / view_.cos_elevation;
  const auto at = [&](std::uint32_t i) { return to_profile_frame(view_, tin_.vertices_m[i]); };

  // The triangle behind the edge is the one in which the edge, seen from inside, runs to the right.
  const bool runs_right = right_of_ray(at(edge.to)) > right_of_ray(at(edge.from));
  const std::uint32_t begins = runs_right ? edge.from : edge.to,
                      ends = runs_right ? edge.to : edge.from;
  std::uint32_t t = kNoTriangle;
  std::size_t k = 0; // the triangle is entered over the side opposite to this vertex
  for (std::uint32_t i = begin_[edge.from]; i < begin_[edge.from + 1]; ++i)
    for (std::size_t n = 0; n < 3; ++n) {
      const auto& triangle = tin_.triangles[triangles_[i]];
      if (triangle[(n + 1) % 3] == begins && triangle[(n + 2) % 3] == ends) {
        t = triangles_[i];
        k = n;
      }
    }
  // A walk passes each triangle once; rounding shall not make it go round.
  for (std::size_t steps = 0; t != kNoTriangle && steps < tin_.triangles.size(); ++steps) {
    const auto& triangle = tin_.triangles[t];
    const bool apex_on_right = right_of_ray(at(triangle[k])) > 0;
    const std::size_t leave = apex_on_right ? (k + 2) % 3 : (k + 1) % 3;
    // As every point on an edge, from the vertex of lower index.
    const auto [low, high] = std::minmax({triangle[(leave + 1) % 3], triangle[(leave + 2) % 3]});
    const ProfilePoint a = at(low), b = at(high);
    const double side_a = right_of_ray(a), side_b = right_of_ray(b);
    const double share = side_a == side_b ? 0.5 : std::clamp(side_a / (side_a - side_b), 0.0, 1.0);
    const ProfilePoint p = point_between(a, b, share);
    const double distance = p.v - from.v;
    if (distance > reach_m) return false;
    // The silhouette's own edge is in reach of rounding: a thousandth of an edge is not behind it.
    const double least_m = 1e-3 * std::max(std::abs(b.u - a.u), std::abs(b.v - a.v));
    if (distance > least_m && p.z >= from.z + distance * z_per_m) return true;
    const std::uint32_t next = tin_.neighbours[t][leave];
    if (next == kNoTriangle) return false;
    const auto& back = tin_.neighbours[next];
    k = static_cast<std::size_t>(std::find(back.begin(), back.end(), t) - back.begin());
    t = next;
  }
  return false;
}

} // namespace orograph
