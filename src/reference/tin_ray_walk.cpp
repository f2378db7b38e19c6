// SPDX-License-Identifier: GPL-3.0-or-later
// The section of a triangle by the vertical plane of a ray is a straight line between the places
// where the plane crosses its edges. Signed distances of vertices from that plane tell which.
#include "reference/tin_ray_walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A place on the surface in the plane of the ray.
struct Met {
  double z, w;     ///< height (exaggerated) and depth
  double rounding; ///< of both together, as a height: the ray may be off to the side
};

// The walk to one point.
class Walk {
public:
  Walk(const View& view, ProfilePoint p, double rounding_m, double highest_m)
      : view_(view), p_(p), rounding_m_(rounding_m), rounding_z_(8 * kEpsilon * highest_m),
        begin_m_(view.is_perspective() ? view.near_m : -kInfinity), own_y_(y_of(p.z, p.v)) {
    const double along = u_along_ray(view, p), length = std::hypot(along, 1);
    aside_u_ = 1 / length;
    aside_v_ = -along / length;
    rounding_z_ += 4 * kEpsilon * std::abs(view.eye_z_m);
  }

  void meet_triangle(const std::array<ProfilePoint, 3>& corners) {
    std::array<double, 3> aside{};
    for (std::size_t i = 0; i < 3; ++i) aside[i] = distance(corners[i]);
    nearest_ = {0, kInfinity, 0};
    farthest_ = {0, -kInfinity, 0};
    for (std::size_t i = 0; i < 3; ++i)
      meet_edge(corners[i], corners[(i + 1) % 3], aside[i], aside[(i + 1) % 3]);
    // Within the section: where the terrain is cut at the near plane, and where it leads up to a
    // place above the point, which then stands under a wall.
    if (nearest_.w < begin_m_ && farthest_.w > begin_m_) meet(on_section(begin_m_));
    if (nearest_.w < p_.v - rounding_m_ && farthest_.w >= p_.v - rounding_m_) {
      const Met above = on_section(p_.v);
      const double y = y_of(above.z, p_.v);
      if (y > own_y_ + 2 * rounding_of_y(above)) {
        take(above);
        found_.greatest_y_apart = std::max(found_.greatest_y_apart, y);
      }
    }
  }

  InFront found() const {
    InFront out = found_;
    out.rounding_m = rounding_m_;
    // Both what may be in front and what certainly is.
    if (greatest_upper_ > -kInfinity)
      out.rounding =
          std::max(greatest_upper_ - found_.greatest_y, found_.greatest_y - greatest_lower_);
    out.rounding +=
        (rounding_z_ + rounding_m_ * std::abs(own_y_)) / (view_.is_perspective() ? p_.v : 1);
    return out;
  }

private:
  double distance(ProfilePoint q) const {
    const ProfilePoint from = view_.is_perspective() ? ProfilePoint{} : p_; // a point of the ray
    return (q.u - from.u) * aside_u_ + (q.v - from.v) * aside_v_;
  }
  double y_of(double z, double w) const { return project(view_, {0, w, z}).y; }
  double rounding_of_y(const Met& met) const {
    const double height = met.rounding + rounding_z_;
    if (!view_.is_perspective()) return height + rounding_m_;
    return (height + rounding_m_ * std::abs(y_of(met.z, met.w))) / met.w;
  }

  // A ray through a vertex, to rounding, meets it; so do both ends of an edge along the ray.
  void meet_edge(ProfilePoint a, ProfilePoint b, double aside_a, double aside_b) {
    const bool at_a = std::abs(aside_a) <= rounding_m_, at_b = std::abs(aside_b) <= rounding_m_;
    if (at_a) meet_on_section({a.z, a.v, 0});
    if (at_b) meet_on_section({b.z, b.v, 0});
    if (at_a || at_b || (aside_a < 0) == (aside_b < 0)) return;
    const ProfilePoint at = point_between(a, b, aside_a / (aside_a - aside_b));
    const double share = rounding_m_ / std::abs(aside_a - aside_b);
    const double per_depth = view_.is_perspective() ? std::abs(y_of(at.z, at.v)) : 1;
    meet_on_section({at.z, at.v, share * (std::abs(b.z - a.z) + per_depth * std::abs(b.v - a.v))});
  }

  void meet_on_section(const Met& met) {
    if (met.w < nearest_.w) nearest_ = met;
    if (met.w > farthest_.w) farthest_ = met;
    meet(met);
  }
  Met on_section(double w) const {
    const double share = std::clamp((w - nearest_.w) / (farthest_.w - nearest_.w), 0.0, 1.0);
    const double steepness =
        std::abs(farthest_.z - nearest_.z) / std::max(farthest_.w - nearest_.w, rounding_m_);
    return {nearest_.z + share * (farthest_.z - nearest_.z), w,
            std::max(nearest_.rounding, farthest_.rounding) + rounding_m_ * steepness};
  }

  void meet(const Met& met) {
    if (met.w >= begin_m_ && met.w < p_.v) take(met);
  }
  void take(const Met& met) {
    const double y = y_of(met.z, met.w), rounding = rounding_of_y(met);
    greatest_upper_ = std::max(greatest_upper_, y + rounding);
    greatest_lower_ = std::max(greatest_lower_, y - rounding);
    if (met.w < p_.v - rounding_m_) found_.greatest_y_apart = std::max(found_.greatest_y_apart, y);
    if (!(y > found_.greatest_y)) return;
    found_.greatest_y = y;
    found_.at_depth_m = met.w;
  }

  const View& view_;
  ProfilePoint p_;
  double rounding_m_; ///< of a ground position
  double rounding_z_; ///< of a height
  double begin_m_;    ///< least depth
  double own_y_;
  double aside_u_, aside_v_;   ///< unit vector across the ray
  Met nearest_{}, farthest_{}; ///< of the present triangle's section
  InFront found_;
  double greatest_upper_ = -kInfinity, greatest_lower_ = -kInfinity;
};

} // namespace

TinRayWalk::TinRayWalk(const Tin& tin, const View& view) : tin_(tin), view_(view), index_(tin) {
  for (const Vec3& vertex : tin.vertices_m) {
    reach_m_ = std::max(reach_m_, std::hypot(vertex.x, vertex.y));
    highest_m_ = std::max(highest_m_, std::abs(vertex.z) * view.exaggeration);
  }
}

InFront TinRayWalk::in_front(ProfilePoint p) const {
  // Sums of products of these lengths, from the ground to the profile frame and back.
  const double rounding_m =
      16 * kEpsilon * (reach_m_ + length(view_.depth_origin_m) + std::abs(p.u) + std::abs(p.v));
  const auto ground = [&](double u, double v) {
    return view_.depth_origin_m + u * view_.right + v * view_.forward;
  };
  const Vec2 at = ground(p.u, p.v);
  // Towards the eye as far as there is terrain.
  const double farther_m = length(at) + reach_m_;
  const Vec2 end = view_.is_perspective()
                       ? ground(p.u / p.v * view_.near_m, view_.near_m)
                       : at - farther_m * (u_along_ray(view_, p) * view_.right + view_.forward);
  Walk walk(view_, p, rounding_m, highest_m_);
  index_.along(at, end, 4 * rounding_m, near_);
  for (const std::uint32_t t : near_) {
    std::array<ProfilePoint, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = to_profile_frame(view_, tin_.vertices_m[tin_.triangles[t][i]]);
    walk.meet_triangle(corners);
  }
  return walk.found();
}

} // namespace orograph
