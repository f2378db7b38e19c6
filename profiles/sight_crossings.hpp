// SPDX-License-Identifier: GPL-3.0-or-later
// A look in one direction, by the edges that its upright plane crosses: what the highest place of
// them is, and the ground at a distance. Whoever finds the edges, each adds the same to a look.
#pragma once

#include "dem/grid.hpp"
#include "geometry/profile_point.hpp"
#include "profiles/sight_lines.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace orograph {

/// A vertex by its distance along a direction and to the left of it.
struct Post {
  double along, aside, z;
};

/// The eye's frame, turned into a direction.
inline View turned_to(const View& view, Vec2 direction) {
  View out = view;
  out.forward = direction.x * view.right + direction.y * view.forward;
  out.right = {out.forward.y, 0 - out.forward.x};
  const auto& [uu, uv, vv] = view.drop;
  const double c = direction.y, s = direction.x; // u = c u' + s v', v = c v' - s u'
  out.drop = {uu * c * c - uv * s * c + vv * s * s, 2 * (uu - vv) * s * c + uv * (c * c - s * s),
              uu * s * s + uv * s * c + vv * c * c};
  return out;
}

/// A grid's vertices in a direction. On a map plane distances grow evenly with columns and rows.
template <class Lattice>
class Posts {
public:
  Posts(const Lattice& lattice, const View& view) : lattice_(lattice), view_(view) {}
  Post at(int column, int row, double height_m) const {
    const Vec3 vertex = lattice_.vertex_m(column, row, height_m);
    const Vec2 from_eye = Vec2{vertex.x, vertex.y} - view_.depth_origin_m;
    const double along = dot(from_eye, view_.forward), right = dot(from_eye, view_.right);
    return {along, 0 - right, vertex.z * view_.exaggeration - view_.drop.at(right, along)};
  }

private:
  const Lattice& lattice_;
  View view_;
};

template <>
class Posts<PlaneLattice> {
public:
  Posts(const PlaneLattice& lattice, const View& view)
      : first_(in_direction(lattice.first_vertex_m - view.depth_origin_m, view)),
        column_(in_direction(lattice.column_step_m, view)),
        row_(in_direction(lattice.row_step_m, view)), exaggeration_(view.exaggeration),
        drop_(view.drop) {}
  Post at(int column, int row, double height_m) const {
    const double along = first_.x + column * column_.x + row * row_.x,
                 aside = first_.y + column * column_.y + row * row_.y;
    return {along, aside, height_m * exaggeration_ - drop_.at(0 - aside, along)};
  }

private:
  static Vec2 in_direction(Vec2 v, const View& view) {
    return {dot(v, view.forward), 0 - dot(v, view.right)};
  }
  Vec2 first_, column_, row_;
  double exaggeration_;
  FrameDrop drop_;
};

/// Where the plane crosses an edge.
struct SightCrossing {
  Post left, right;
  double along, z;

  /// `aside` of the left end is not below that of the right one.
  static SightCrossing of(const Post& left, const Post& right) {
    const double share = std::clamp(left.aside / (left.aside - right.aside), 0.0, 1.0);
    return {left, right, left.along + share * (right.along - left.along),
            left.z + share * (right.z - left.z)};
  }
};

/// What the edges that were met have added. The order in which they are taken changes nothing but
/// by which of them a place is told that several cross at the same distance.
class SightCrossings {
public:
  /// Of edges nearer than `distance_m`; `rounding_m` is `SightLines::rounding_m`.
  SightCrossings(double distance_m, double rounding_m, double eye_z_m)
      : distance_m_(distance_m), rounding_m_(rounding_m), nearest_m_(4 * rounding_m),
        eye_z_m_(eye_z_m) {}

  double slope() const { return slope_; } ///< the greatest so far

  /// Whether a vertex is as far away as the distance asked for.
  bool reaches(const Post& post) const { return post.along >= distance_m_ - rounding_m_; }
  bool is_past(const SightCrossing& at) const { return at.along > distance_m_ + off_m(at); }
  bool is_between(const SightCrossing& at) const {
    return at.along > nearest_m_ && at.along < distance_m_;
  }
  /// On an edge slopes are between those of its ends: most edges need no more.
  bool adds_nothing(const Post& left, const Post& right) const {
    return (is_below(left) && is_below(right)) ||
           (left.along <= nearest_m_ && right.along <= nearest_m_);
  }

  /// Whether it is the highest place now. REQUIRES that it `is_between`.
  bool take(const SightCrossing& at) {
    const double slope = (at.z - eye_z_m_) / at.along;
    if (!(slope > slope_) && !(slope == slope_ && highest_ && at.along > highest_->along))
      return false;
    // Rounding may as well have it under the eye.
    const double across = at.left.aside - at.right.aside,
                 along = std::abs(at.right.along - at.left.along);
    if (!(at.along * across > 4 * rounding_m_ * (across + along))) return false;
    highest_ = at;
    slope_ = slope;
    return true;
  }
  /// About a vertex in the plane all edges are crossed at that vertex.
  bool is_highest(const SightCrossing& at) const {
    return highest_ && std::abs(at.along - highest_->along) <= off_m(at) + off_m(*highest_);
  }

  /// Of the section from one crossing to the next.
  void take_ground(const SightCrossing& from, const SightCrossing& to) {
    if (is_past(from) || to.along < distance_m_ - off_m(to)) return;
    const double on = to.along - from.along, rise = to.z - from.z;
    double z = std::max(from.z, to.z); // a wall
    if (on > 2 * rounding_m_)
      z = from.z + std::clamp((distance_m_ - from.along) / on, 0.0, 1.0) * rise;
    if (ground_ && ground_->z_m >= z) return;
    const double steep = std::abs(rise) * std::min(1.0, rounding_m_ / std::max(on, rounding_m_));
    ground_ = SightPlace{distance_m_, z,
                         std::max(place_of(from).rounding_m, place_of(to).rounding_m) + steep};
  }

  SightLine found(bool at_border) const {
    SightLine out;
    out.ground = ground_;
    if (!highest_) return out;
    out.highest = place_of(*highest_);
    out.slope = slope_;
    out.rounding = (out.highest->rounding_m + rounding_m_ * std::abs(slope_)) / highest_->along;
    out.at_border = at_border;
    return out;
  }

private:
  bool is_below(const Post& post) const {
    return post.along > nearest_m_ && post.z - eye_z_m_ < slope_ * post.along;
  }
  // By which share of its edge, at most, rounding may have moved it.
  double off_share(const SightCrossing& at) const {
    return std::min(rounding_m_ / (at.left.aside - at.right.aside), 1.0);
  }
  double off_m(const SightCrossing& at) const {
    return rounding_m_ + off_share(at) * std::abs(at.right.along - at.left.along);
  }
  SightPlace place_of(const SightCrossing& at) const {
    constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
    const double slope = std::abs(at.z - eye_z_m_) / std::max(std::abs(at.along), nearest_m_);
    const double moved =
        std::abs(at.right.z - at.left.z) + slope * std::abs(at.right.along - at.left.along);
    return {at.along, at.z,
            off_share(at) * moved +
                8 * kEpsilon * (std::abs(at.left.z) + std::abs(at.right.z) + std::abs(eye_z_m_))};
  }

  double distance_m_, rounding_m_, nearest_m_, eye_z_m_;
  std::optional<SightCrossing> highest_;
  double slope_ = -std::numeric_limits<double>::infinity();
  std::optional<SightPlace> ground_;
};

} // namespace orograph
