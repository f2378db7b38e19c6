// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/ray_walk.hpp"

#include "dem/approximate/tin_of_grid.hpp"
#include "dem/height_at.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

namespace orograph {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// Terrain is cut at the near plane; but where a view draws nothing close behind that plane, nearer
// ground is looked at as well, which shows whether it does.
double nearest_m(const View& view) {
  return view.drawn_from_m > view.near_m ? view.near_m * (view.near_m / view.drawn_from_m)
                                         : view.near_m;
}

int whole(double number) {
  return static_cast<int>(std::floor(number));
}

// The walk over a grid to one point. Along the vertical plane of a ray, column and row are linear
// in depth w: at the point, plus (w - the point's depth) * per_m. Three families of parallel lines
// hold all edges: columns, rows, and the diagonals, on each of which column - row is constant.
template <class Height>
struct GridWalk {
  const View& view;
  const Height& z_m; ///< by column and row, in the profile frame; NaN where there is none
  int columns, rows;
  double depth_m, column, row; ///< the point's
  double column_per_m, row_per_m;
  double begin_m;              ///< least depth
  double rounding_m, rounding; ///< of a ground position, in metres and in cells
  double rounding_z;           ///< of a height on the surface, metres, exaggerated
  InFront found{};
  // Rounding decides between these which Y is the greatest.
  double greatest_upper = -kInfinity, greatest_lower = greatest_upper;

  double y_of(double z, double w) const { return project(view, {0, w, z}).y; }
  double rounding_of_y(double y, double w) const {
    return view.is_perspective() ? (rounding_z + rounding_m * std::abs(y)) / w
                                 : rounding_z + rounding_m;
  }

  void meet(double z, double w) {
    const double y = y_of(z, w);
    const double rounding_y = rounding_of_y(y, w);
    greatest_upper = std::max(greatest_upper, y + rounding_y);
    greatest_lower = std::max(greatest_lower, y - rounding_y);
    if (w < depth_m - rounding_m) found.greatest_y_apart = std::max(found.greatest_y_apart, y);
    if (!(y > found.greatest_y)) return;
    found.greatest_y = y;
    found.at_depth_m = w;
  }

  // The edge from vertex (c, r) to the one `right` columns and `down` rows on, at share t of it. It
  // is there if one of its two triangles is.
  void meet_edge(int c, int r, int right, int down, double t, double w) {
    const bool diagonal = right == down;
    const double from = z_m(c, r), to = z_m(c + right, r + down);
    const double third = diagonal ? z_m(c + 1, r) : z_m(c - down, r - right);
    const double other = diagonal ? z_m(c, r + 1) : z_m(c + 1, r + 1);
    if (std::isnan(from) || std::isnan(to) || (std::isnan(third) && std::isnan(other))) return;
    meet(from + std::clamp(t, 0.0, 1.0) * (to - from), w);
  }

  // All crossings with one family of lines that are strictly in front of the point, which lies on
  // line `number`, at `along` of it; both are linear in depth. `meet_at` gets the line, the edge
  // along it, the share of that edge, and the depth.
  template <class MeetAt>
  void meet_lines(double number, double number_per_m, int first, int last, double along,
                  double along_per_m, const MeetAt& meet_at) {
    if (number_per_m == 0) return; // the ray keeps to its line and crosses those of the others
    const double begin = number + (begin_m - depth_m) * number_per_m;
    const double low = std::clamp(std::min(begin, number), first - 1.0, last + 1.0);
    const double high = std::clamp(std::max(begin, number), first - 1.0, last + 1.0);
    for (int line = std::max(whole(low), first); line <= std::min(whole(high) + 1, last); ++line) {
      const double w = depth_m + (line - number) / number_per_m;
      if (!(w >= begin_m && w < depth_m)) continue;
      const double place = along + (w - depth_m) * along_per_m;
      if (!(place > -1 && place < std::max(columns, rows))) continue;
      // Near a vertex, both edges that meet there.
      for (int edge = whole(place - rounding); edge <= whole(place + rounding); ++edge)
        meet_at(line, edge, place - edge, w);
    }
  }

  void meet_all() {
    meet_lines(column, column_per_m, 0, columns - 1, row, row_per_m,
               [&](int c, int r, double t, double w) { meet_edge(c, r, 0, 1, t, w); });
    meet_lines(row, row_per_m, 0, rows - 1, column, column_per_m,
               [&](int r, int c, double t, double w) { meet_edge(c, r, 1, 0, t, w); });
    meet_lines(column - row, column_per_m - row_per_m, 2 - rows, columns - 2, column, column_per_m,
               [&](int line, int c, double t, double w) { meet_edge(c, c - line, 1, 1, t, w); });
  }
};

} // namespace

GridRayWalk::GridRayWalk(const Grid& grid, const View& view) : grid_(grid), view_(view) {
  const auto& [first_vertex_m, column_step_m, row_step_m] = grid.plane();
  const double area = cross(column_step_m, row_step_m);
  per_column_ = (1 / area) * Vec2{row_step_m.y, -row_step_m.x};
  per_row_ = (1 / area) * Vec2{-column_step_m.y, column_step_m.x};
  for (int r = 0; r < grid.rows; r += grid.rows - 1)
    for (int c = 0; c < grid.columns; c += grid.columns - 1)
      reach_m_ = std::max(reach_m_, length(grid.plane().position_m(c, r)));
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c) {
      const double here = grid.height_m(c, r);
      // fmax leaves out a NaN.
      highest_m_ = std::fmax(highest_m_, std::abs(here));
      for (const auto& [i, j] : {std::pair{c + 1, r}, {c, r + 1}, {c + 1, r + 1}})
        if (i < grid.columns && j < grid.rows)
          steepest_m_ = std::fmax(steepest_m_, std::abs(grid.height_m(i, j) - here));
    }
}

InFront GridRayWalk::in_front(ProfilePoint p) const {
  const Vec2 ground = view_.depth_origin_m + p.u * view_.right + p.v * view_.forward;
  const Vec2 from_first = ground - grid_.plane().first_vertex_m;
  const Vec2 per_m = u_along_ray(view_, p) * view_.right + view_.forward;
  // Sums of products of these lengths, from the ground to the profile frame and back.
  const double rounding_m =
      16 * kEpsilon * (reach_m_ + length(view_.depth_origin_m) + std::abs(p.u) + std::abs(p.v));
  const double rounding = rounding_m * (length(per_column_) + length(per_row_));
  // No ground on the way sinks more than a point that far off in any direction.
  const double away_m = reach_m_ + length(view_.depth_origin_m);
  const double greatest_drop_m =
      (std::abs(view_.drop.per_uu) + std::abs(view_.drop.per_uv) + std::abs(view_.drop.per_vv)) *
      away_m * away_m;
  // A position that is off by a share of a cell has a height that is off by as much of two edges.
  const double rounding_z =
      view_.exaggeration * (2 * rounding * steepest_m_ + 8 * kEpsilon * highest_m_) +
      4 * kEpsilon * std::abs(view_.eye_z_m) + 8 * kEpsilon * greatest_drop_m;
  return std::visit(
      [&](const auto& heights) {
        const auto z_m = [&](int c, int r) {
          if (c < 0 || r < 0 || c >= grid_.columns || r >= grid_.rows)
            return std::numeric_limits<double>::quiet_NaN();
          const double height = heights[grid_.index(c, r)];
          return to_profile_frame(view_, grid_.plane().vertex_m(c, r, height)).z;
        };
        const double begin_m = view_.is_perspective() ? nearest_m(view_) : -kInfinity;
        GridWalk<decltype(z_m)> walk{view_,
                                     z_m,
                                     grid_.columns,
                                     grid_.rows,
                                     p.v,
                                     dot(per_column_, from_first),
                                     dot(per_row_, from_first),
                                     dot(per_column_, per_m),
                                     dot(per_row_, per_m),
                                     begin_m,
                                     rounding_m,
                                     rounding,
                                     rounding_z};
        walk.meet_all();
        // In perspective, terrain is cut at the near plane.
        if (view_.is_perspective() && begin_m < p.v)
          if (const auto z = height_at(grid_, ground - (p.v - begin_m) * per_m, z_m))
            walk.meet(*z, begin_m);
        walk.found.rounding_m = rounding_m;
        if (walk.greatest_upper > -kInfinity)
          walk.found.rounding = std::max(walk.greatest_upper - walk.found.greatest_y,
                                         walk.found.greatest_y - walk.greatest_lower);
        walk.found.rounding += walk.rounding_of_y(walk.y_of(p.z, p.v), p.v);
        return walk.found;
      },
      grid_.heights_m);
}

namespace {

// A place on the surface in the plane of the ray.
struct Met {
  double z, w;     ///< height (exaggerated) and depth
  double rounding; ///< of both together, as a height: the ray may be off to the side
};

// The walk over a TIN to one point. The section of a triangle by the vertical plane of a ray is a
// straight line between the places where the plane crosses its edges. Signed distances of vertices
// from that plane tell which.
class TinWalk {
public:
  TinWalk(const View& view, ProfilePoint p, double rounding_m, double highest_m)
      : view_(view), p_(p), rounding_m_(rounding_m), rounding_z_(8 * kEpsilon * highest_m),
        begin_m_(view.is_perspective() ? nearest_m(view) : -kInfinity), own_y_(y_of(p.z, p.v)) {
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
    // What is nearer than the near plane is met there: straight under the eye Y has no bounds.
    const double per_depth =
        view_.is_perspective() ? std::abs(y_of(at.z, std::max(at.v, begin_m_))) : 1;
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
    highest_m_ = std::max(highest_m_, std::abs(vertex.z));
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
                       ? ground(p.u / p.v * nearest_m(view_), nearest_m(view_))
                       : at - farther_m * (u_along_ray(view_, p) * view_.right + view_.forward);
  TinWalk walk(view_, p, rounding_m, highest_m_ * view_.exaggeration);
  index_.along(at, end, 4 * rounding_m, near_);
  for (const std::uint32_t t : near_) {
    std::array<ProfilePoint, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = to_profile_frame(view_, tin_.vertices_m[tin_.triangles[t][i]]);
    walk.meet_triangle(corners);
  }
  return walk.found();
}

namespace {

using Walk = std::variant<GridRayWalk, TinRayWalk>;

std::shared_ptr<const Tin> triangles_of(const Grid& grid) {
  return grid.is_on_earth() ? std::make_shared<const Tin>(tin_of(grid)) : nullptr;
}

Walk walk_over(const Grid& grid, const Tin* triangles, const View& view) {
  return triangles ? Walk(std::in_place_type<TinRayWalk>, *triangles, view)
                   : Walk(std::in_place_type<GridRayWalk>, grid, view);
}

} // namespace

RayWalk::RayWalk(const Grid& grid, const View& view)
    : triangles_(triangles_of(grid)), walk_(walk_over(grid, triangles_.get(), view)) {}

RayWalk::RayWalk(const Tin& tin, const View& view)
    : walk_(std::in_place_type<TinRayWalk>, tin, view) {}

RayWalk::RayWalk(const Surface& surface, const View& view)
    : RayWalk(std::holds_alternative<Grid>(surface) ? RayWalk(std::get<Grid>(surface), view)
                                                    : RayWalk(std::get<Tin>(surface), view)) {}

} // namespace orograph
