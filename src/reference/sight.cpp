// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sight.hpp"

#include "dem/approximate/tin_of_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace orograph {
namespace {

constexpr long double kLongInfinity = std::numeric_limits<long double>::infinity();

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
    long double most = -kLongInfinity;
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

SightAnswer GroundSight::ask(ProfilePoint p, long double margin_m) const {
  const long double m = margin_m;
  const bool plumb = !view_.is_perspective() && view_.y_per_z == 0;
  const Asked asked{triangles_, plane_of(view_, long_vec(p)),
                    view_.is_perspective() ? static_cast<long double>(view_.near_m) - p.v
                    : plumb                ? 0
                                           : -kLongInfinity};
  // A section has a width, so that the rounding of its ends doesn't lose it.
  const long double width = 1e-17L * (reach_m_ + std::abs(p.u) + std::abs(p.v));
  const auto in_plane = [&](long double aside, Range behind) {
    return asked.greatest({aside - width, aside + width},
                          {behind.low - width, behind.high + width});
  };
  SightAnswer verdict;
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

namespace {

// Rays around a segment, parallel to it, none of them in a direction that scenes have.
std::vector<SightSegment> rays_around(const SightSegment& segment, long double away_m) {
  const LongVec along = segment.to - segment.from;
  const LongVec aside = std::abs(along.z) > std::abs(along.u) ? LongVec{1, 0, 0} : LongVec{0, 0, 1};
  const LongVec first = cross(along, aside), second = cross(along, first);
  std::vector<SightSegment> rays;
  for (int k = 0; k < 16; ++k) {
    const long double turn = 0.123L + k * std::numbers::pi_v<long double> / 8;
    const LongVec by =
        (std::cos(turn) / length(first)) * first + (std::sin(turn) / length(second)) * second;
    for (const long double share : {1.0L, 1 / 3.0L})
      rays.push_back({segment.from + (share * away_m) * by, segment.to + (share * away_m) * by});
  }
  return rays;
}

} // namespace

SolidSight::SolidSight(std::span<const StandingSolid> solids, const View& view)
    : view_(view), solids_(solids) {
  for (std::size_t s = 0; s < solids.size(); ++s) {
    std::vector<LongVec> places;
    for (const Vec3& vertex : solids[s].vertices_m) {
      const ProfilePoint p = to_profile_frame(view, vertex);
      places.push_back(long_vec(p));
      reach_m_ = std::max({reach_m_, std::abs(vertex.x), std::abs(vertex.y), std::abs(p.u),
                           std::abs(p.v), std::abs(p.z)});
    }
    const auto& triangles = solids[s].solid->triangles;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      Face face{{}, {}, 0, s, t};
      for (std::size_t k = 0; k < 3; ++k) {
        face.corners[k] = places[triangles[t][k]];
        face.middle = face.middle + (1 / 3.0L) * face.corners[k];
      }
      for (const LongVec& corner : face.corners)
        face.radius_m = std::max(face.radius_m, length(corner - face.middle));
      faces_.push_back(face);
    }
  }
}

SightSegment SolidSight::segment_to(LongVec p) const {
  if (view_.is_perspective()) return {{0, 0, view_.eye_z_m}, p};
  // X and Y don't change along it; seen straight down it is upright.
  LongVec to_viewer{static_cast<long double>(view_.x_per_v) * view_.y_per_z, -view_.y_per_z,
                    view_.y_per_v};
  long double far_m = 1;
  for (const Face& face : faces_)
    far_m = std::max(far_m, 2 * (length(face.middle - p) + face.radius_m));
  return {p + (far_m / length(to_viewer)) * to_viewer, p};
}

bool SolidSight::is_own(const Face& face, LongVec p, long double margin_m, const Own& own) const {
  if (own.which == Own::Which::edge) {
    if (own.solid != face.solid) return false;
    const SolidEdge& edge = solids_[own.solid].solid->edges[own.edge];
    return edge.left == face.triangle || edge.right == face.triangle;
  }
  return own.which == Own::Which::all_touching && distance_m(p, face.corners) <= margin_m;
}

SightAnswer SolidSight::ask(ProfilePoint point, long double margin_m, const Own& own) const {
  const LongVec p = long_vec(point);
  const SightSegment segment = segment_to(p);
  SightAnswer verdict;
  std::vector<const Face*> close;
  for (const Face& face : faces_) {
    if (distance_m(face.middle, segment) > face.radius_m + margin_m) continue;
    if (is_own(face, p, margin_m, own)) continue;
    if (surely_crosses(segment, face.corners, margin_m)) return {true, false};
    if (distance_m(segment, face.corners) > margin_m) continue;
    close.push_back(&face);
    verdict.hidden = verdict.hidden || crosses(segment, face.corners);
  }
  if (close.empty()) return verdict;

  // Across an edge within a surface all rays still meet one triangle or another. What touches the
  // point itself isn't counted on.
  std::erase_if(close, [&](const Face* face) { return distance_m(p, face->corners) <= margin_m; });
  verdict.unsure = true;
  const std::vector<SightSegment> rays = rays_around(segment, margin_m);
  for (std::size_t s = 0; s < solids_.size() && verdict.unsure; ++s) {
    const bool all = std::all_of(rays.begin(), rays.end(), [&](const SightSegment& ray) {
      return std::any_of(close.begin(), close.end(), [&](const Face* face) {
        return face->solid == s && crosses(ray, face->corners);
      });
    });
    if (all) verdict = {true, false};
  }
  return verdict;
}

Sight::Sight(const Surface& surface, std::span<const StandingSolid> solids, const View& view)
    : ground_(surface, view), solids_(solids, view) {
  reach_m_ = std::max(
      {ground_.reach_m(), solids_.reach_m(), length(view.depth_origin_m), std::abs(view.eye_z_m)});
}

// Places are sums of a few products of such lengths, in double.
long double Sight::margin_m(ProfilePoint p, double slack_m) const {
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  return slack_m + kRounding * std::max({reach_m_, std::abs(p.u), std::abs(p.v), std::abs(p.z)});
}

SightAnswer Sight::by_ground(ProfilePoint p, double slack_m) const {
  return ground_.ask(p, margin_m(p, slack_m));
}

SightAnswer Sight::by_solids(ProfilePoint p, double slack_m, const Own& own) const {
  return solids_.ask(p, margin_m(p, slack_m), own);
}

Sight::Answer Sight::ask(ProfilePoint p, double slack_m, const Own& own) const {
  const SightAnswer ground = by_ground(p, slack_m), solids = by_solids(p, slack_m, own);
  const bool sure = ground.surely_hidden() || solids.surely_hidden() ||
                    (ground.surely_visible() && solids.surely_visible());
  return {ground.hidden, solids.hidden, !sure};
}

} // namespace orograph
