// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/ground_sight.hpp"

#include "dem/approximate/tin_of_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr long double kInfinity = std::numeric_limits<long double>::infinity();

// A linear function of a place.
struct Linear {
  LongVec per_m;
  long double at_origin = 0;
  long double of(LongVec q) const { return dot(per_m, q) + at_origin; }
};

// What the vertical plane of a point's ray is, in metres from the point or its ray.
struct RayPlane {
  Linear aside;  ///< from the plane
  Linear behind; ///< of the point, in depth
  Linear above;  ///< the ray, across it
};

RayPlane plane_of(const View& view, LongVec p) {
  RayPlane plane;
  plane.behind = {{0, 1, 0}, -p.v};
  if (view.is_perspective()) {
    const long double away = std::hypot(p.u, p.v), y = (p.z - view.eye_z_m) / p.v;
    plane.aside = {{p.v / away, -p.u / away, 0}, 0};
    const long double per_m = 1 / std::hypot(1.0L, y);
    plane.above = {{0, -y * per_m, per_m}, -view.eye_z_m * per_m};
    return plane;
  }
  const auto through_p = [&](LongVec per_m) {
    per_m = (1 / length(per_m)) * per_m;
    return Linear{per_m, -dot(per_m, p)};
  };
  plane.aside = through_p({1, view.x_per_v, 0});
  plane.above =
      view.y_per_z == 0 ? through_p({0, 0, 1}) : through_p({0, view.y_per_v, view.y_per_z});
  return plane;
}

struct Range {
  long double low, high;
};

// A triangle cut by up to four half-spaces.
struct Polygon {
  std::array<LongVec, 16> corners; ///< room for what rounding adds
  std::size_t size = 0;

  void add(LongVec corner) { corners[size++] = corner; }

  // Keeps sign * (f - limit) <= 0.
  void cut(const Linear& f, long double limit, int sign) {
    if (!std::isfinite(limit)) return;
    Polygon left;
    for (std::size_t i = 0; i < size; ++i) {
      const LongVec a = corners[i], b = corners[(i + 1) % size];
      const long double at_a = sign * (f.of(a) - limit), at_b = sign * (f.of(b) - limit);
      if (at_a <= 0) left.add(a);
      if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0))
        left.add(a + (at_a / (at_a - at_b)) * (b - a));
    }
    *this = left;
  }
};

struct Asked {
  const std::vector<LongTriangle>& triangles;
  RayPlane plane;
  long double nearest; ///< ground, behind the point

  // How far ground within the ranges reaches above the ray at most.
  long double greatest(Range aside, Range behind) const {
    long double most = -kInfinity;
    for (const LongTriangle& t : triangles) {
      const auto [low, high] =
          std::minmax({plane.aside.of(t[0]), plane.aside.of(t[1]), plane.aside.of(t[2])});
      if (low > aside.high || high < aside.low) continue;
      Polygon part;
      for (const LongVec& corner : t) part.add(corner);
      part.cut(plane.aside, aside.low, -1);
      part.cut(plane.aside, aside.high, 1);
      part.cut(plane.behind, behind.low, -1);
      part.cut(plane.behind, behind.high, 1);
      for (std::size_t i = 0; i < part.size; ++i)
        most = std::max(most, plane.above.of(part.corners[i]));
    }
    return most;
  }
};

} // namespace

GroundSight::GroundSight(const Surface& surface, const View& view) : view_(view) {
  const Tin* tin = std::get_if<Tin>(&surface);
  const Tin made = tin ? Tin{} : tin_of(std::get<Grid>(surface));
  if (!tin) tin = &made;
  std::vector<ProfilePoint> vertices;
  for (const Vec3& vertex : tin->vertices_m) {
    const ProfilePoint p = vertices.emplace_back(to_profile_frame(view, vertex));
    reach_m_ = std::max({reach_m_, std::abs(vertex.x), std::abs(vertex.y), std::abs(p.u),
                         std::abs(p.v), std::abs(p.z)});
  }
  for (const auto& [a, b, c] : tin->triangles)
    triangles_.push_back({long_vec(vertices[a]), long_vec(vertices[b]), long_vec(vertices[c])});
}

Verdict GroundSight::ask(ProfilePoint p, long double margin_m) const {
  const long double m = margin_m;
  const bool plumb = !view_.is_perspective() && view_.y_per_z == 0;
  const Asked asked{triangles_, plane_of(view_, long_vec(p)),
                    view_.is_perspective() ? static_cast<long double>(view_.near_m) - p.v
                    : plumb                ? 0
                                           : -kInfinity};
  // A section has a width, so that the rounding of its ends doesn't lose it.
  const long double width = 1e-17L * (reach_m_ + std::abs(p.u) + std::abs(p.v));
  const auto in_plane = [&](long double aside, Range behind) {
    return asked.greatest({aside - width, aside + width},
                          {behind.low - width, behind.high + width});
  };
  Verdict verdict;
  verdict.hidden = in_plane(0, {asked.nearest, 0}) > 0;
  if (!verdict.hidden) {
    verdict.unsure = asked.greatest({-m, m}, {asked.nearest - m, m}) > -m;
    return verdict;
  }
  for (const long double aside : {-m, 0.0L, m}) {
    if (plumb)
      for (const long double behind : {-m, 0.0L, m})
        verdict.unsure = verdict.unsure || !(in_plane(aside, {behind, behind}) > m);
    else
      verdict.unsure = verdict.unsure || !(in_plane(aside, {asked.nearest + m, -m}) > m);
  }
  return verdict;
}

} // namespace orograph
