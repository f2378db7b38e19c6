// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/solid_sight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orograph {
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

Verdict SolidSight::ask(ProfilePoint point, long double margin_m, const Own& own) const {
  const LongVec p = long_vec(point);
  const SightSegment segment = segment_to(p);
  Verdict verdict;
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

} // namespace orograph
