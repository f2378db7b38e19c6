// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/solids_in_view.hpp"

#include "geometry/box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace orograph {
namespace {

using Corners = std::array<std::uint32_t, 3>;

// The corners of a triangle, counterclockwise from outside.
Corners outward(const StandingSolid& standing, std::size_t triangle) {
  Corners corners = standing.solid->triangles[triangle];
  if (standing.mirrored) std::swap(corners[1], corners[2]);
  return corners;
}

Vec3 normal_of(const std::vector<Vec3>& vertices, const Corners& t) {
  return cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]);
}

// A triangle's plane, and how well rounded corners tell it.
struct FacePlane {
  Vec3 normal; // of the length of twice the area
  double longest_m, height_m;

  explicit FacePlane(const std::array<Vec3, 3>& p)
      : normal(cross(p[1] - p[0], p[2] - p[0])),
        longest_m(std::max({length(p[1] - p[0]), length(p[2] - p[1]), length(p[0] - p[2])})),
        height_m(length(normal) / longest_m) {}

  // How far the plane may be off at the triangle. A sliver says nothing of a plane: beyond some
  // length nothing is taken for touching.
  double rounding_m(double of_corners_m) const {
    constexpr double kMost = 1e6;
    return of_corners_m * (height_m > 0 ? std::min(4 + 4 * longest_m / height_m, kMost) : kMost);
  }
  // By more than rounding.
  bool is_light(const SightRays& rays, Vec3 corner, double of_corners_m) const {
    if (!(height_m > 0)) return false;
    const Vec3 to_eye = rays.parallel ? -1.0 * rays.from : rays.from - corner;
    const double off =
        of_corners_m * (rays.parallel ? 0 : 1) + of_corners_m * length(to_eye) / height_m;
    return dot(normal, to_eye) > 4 * off * length(normal);
  }
};

// Whether the solid fills more than half of the space about an edge.
bool is_reflex(const SolidInView& solid, const SolidEdge& edge) {
  const Corners right = outward(*solid.standing, edge.right);
  const auto* const apex = std::find_if(
      right.begin(), right.end(), [&](std::uint32_t v) { return v != edge.from && v != edge.to; });
  const Vec3 normal = normal_of(solid.vertices, outward(*solid.standing, edge.left));
  return dot(normal, solid.vertices[*apex] - solid.vertices[edge.from]) > 0;
}

EdgeFacing facing_of(const SolidInView& solid, const SolidEdge& edge,
                     const std::vector<bool>& light) {
  if (edge.is_wire()) return EdgeFacing::seen;
  const bool left = light[edge.left], right = light[edge.right];
  const bool smooth_inside = edge.smooth && left == right;
  if (!left && !right) return smooth_inside ? EdgeFacing::not_drawn : EdgeFacing::dark;
  if (smooth_inside) return EdgeFacing::not_drawn;
  return !(left && right) && is_reflex(solid, edge) ? EdgeFacing::dark : EdgeFacing::seen;
}

} // namespace

SeenBox seen_box(const View& view, const Vec3* points, std::size_t count) {
  SeenBox box{kInfinity, -kInfinity, kInfinity, -kInfinity, kInfinity, -kInfinity};
  for (const Vec3* p = points; p != points + count; ++p) {
    box.nearest_m = std::min(box.nearest_m, p->y);
    box.farthest_m = std::max(box.farthest_m, p->y);
  }
  if (view.is_perspective() && !(box.nearest_m > view.near_m / 2))
    return {-kInfinity, kInfinity, -kInfinity, kInfinity, box.nearest_m, box.farthest_m};
  for (const Vec3* p = points; p != points + count; ++p) {
    const Vec2 at = project(view, {p->x, p->y, p->z});
    box.x_begin = std::min(box.x_begin, at.x);
    box.x_end = std::max(box.x_end, at.x);
    box.y_low = std::min(box.y_low, at.y);
    box.y_high = std::max(box.y_high, at.y);
  }
  return box;
}

double rounding_of_positions_m(const StandingSolid& standing, const View& view) {
  double reach_m = length(view.depth_origin_m);
  for (const Vec3& vertex : standing.vertices_m)
    reach_m = std::max({reach_m, length(vertex), length(as_vec(to_profile_frame(view, vertex)))});
  return 16 * std::numeric_limits<double>::epsilon() * reach_m;
}

SolidInView in_view(const StandingSolid& standing, const View& view) {
  const Solid& solid = *standing.solid;
  SolidInView out;
  out.standing = &standing;
  for (const Vec3& vertex : standing.vertices_m)
    out.vertices.push_back(as_vec(to_profile_frame(view, vertex)));
  out.rounding_m = rounding_of_positions_m(standing, view);
  out.box = seen_box(view, out.vertices.data(), out.vertices.size());

  const SightRays rays = sight_rays(view);
  std::vector<bool> light(solid.triangles.size());
  for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
    const Corners order = outward(standing, i);
    const std::array<Vec3, 3> corners{out.vertices[order[0]], out.vertices[order[1]],
                                      out.vertices[order[2]]};
    const FacePlane plane(corners);
    light[i] = plane.is_light(rays, corners[0], out.rounding_m);
    const SeenBox box = seen_box(view, corners.data(), corners.size());
    if (!light[i] || is_behind_eye(view, box)) continue;
    out.shadows.push_back({triangle_shadow(rays, corners, order, plane.rounding_m(out.rounding_m)),
                           box, static_cast<std::uint32_t>(i)});
  }
  for (const SolidEdge& edge : solid.edges) out.edges.push_back(facing_of(out, edge, light));
  return out;
}

SolidsInView::SolidsInView(std::span<const StandingSolid> standing, const View& view)
    : view_(view), x_begin_(kInfinity), x_end_(-x_begin_) {
  std::vector<std::uint32_t> inside;
  for (const StandingSolid& one : standing) {
    const auto number = static_cast<std::uint32_t>(solids_.size());
    solids_.push_back(in_view(one, view));
    sliver_m_ = std::max(sliver_m_, 256 * solids_.back().rounding_m);
    const SeenBox& box = solids_.back().box;
    if (is_behind_eye(view, box)) continue;
    x_begin_ = std::min(x_begin_, box.x_begin);
    x_end_ = std::max(x_end_, box.x_end);
    if (std::isinf(box.x_begin)) {
      everywhere_.push_back(number);
      continue;
    }
    core_.include({box.x_begin, box.y_low});
    core_.include({box.x_end, box.y_high});
    inside.push_back(number);
  }
  if (inside.empty()) return;
  // Where solids stand apart most buckets are empty, and a line that passes by them costs a look.
  constexpr double kMost = 256;
  side_ = static_cast<std::size_t>(
      std::clamp(4 * std::sqrt(static_cast<double>(inside.size())), 1.0, kMost));
  buckets_.resize(side_ * side_);
  columns_.resize(side_);
  const auto per = [&](double size) { return size > 0 ? static_cast<double>(side_) / size : 0; };
  per_x_ = per(core_.width());
  per_y_ = per(core_.height());
  for (const std::uint32_t i : inside) {
    const SeenBox& box = solids_[i].box;
    for (std::size_t c = column_of(box.x_begin); c <= column_of(box.x_end); ++c)
      columns_[c].push_back(i);
    for (std::size_t r = row_of(box.y_low); r <= row_of(box.y_high); ++r)
      for (std::size_t c = column_of(box.x_begin); c <= column_of(box.x_end); ++c)
        buckets_[r * side_ + c].push_back(i);
  }
}

void SolidsInView::add_hidden(const LineInView& line, const OwnEdge& own,
                              std::vector<Share>& hidden) const {
  for_each_before(line.box, [&](std::size_t i) {
    for (const TriangleShadow& triangle : solids_[i].shadows) {
      if (!overlap(triangle.box, line.box)) continue;
      if (i == own.solid && (triangle.triangle == own.left || triangle.triangle == own.right))
        continue;
      if (const auto share = hidden_share(triangle.shadow, line.from, line.to))
        hidden.push_back(*share);
    }
  });
}

namespace {

struct Corner {
  Vec3 from_eye;
  std::uint32_t number;
};

// Whether the eye is left of the edge a -> b, seen from above; exactly the opposite for b -> a.
bool is_left(const Corner& a, const Corner& b) {
  const bool turned = a.number > b.number;
  const Vec3 p = turned ? b.from_eye : a.from_eye, q = turned ? a.from_eye : b.from_eye;
  const double cross_z = p.x * q.y - p.y * q.x;
  return (cross_z > 0) != turned;
}

// How an edge crosses the half plane north of the upright through the eye: half open, so that a
// vertex on it is crossed once.
int crossing(const Corner& a, const Corner& b) {
  const bool a_west = a.from_eye.x < 0, b_west = b.from_eye.x < 0;
  if (a_west == b_west || is_left(a, b) != b_west) return 0;
  return b_west ? 1 : -1;
}

// Whether a triangle that the upright through the eye goes through is above the eye there.
bool is_above(std::span<const Corner, 3> corners, double rounding_m) {
  const auto plan = [](const Corner& corner) { return Vec2{corner.from_eye.x, corner.from_eye.y}; };
  const Vec2 a = plan(corners[0]), ab = plan(corners[1]) - a, ac = plan(corners[2]) - a;
  const double area = cross(ab, ac);
  if (std::abs(area) > rounding_m * (length(ab) + length(ac))) {
    const double height_by_area =
        dot(corners[0].from_eye, cross(corners[1].from_eye, corners[2].from_eye));
    return (height_by_area > 0) == (area > 0);
  }
  // It stands upright, so that its plane goes through the eye: its sides tell.
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner &from = corners[i], &to = corners[(i + 1) % 3];
    const Vec2 way = plan(to) - plan(from);
    const double square = dot(way, way);
    const double t = square > 0 ? std::clamp(-dot(plan(from), way) / square, 0.0, 1.0) : 0;
    if (length(plan(from) + t * way) <= rounding_m)
      lowest = std::min(lowest, from.from_eye.z + t * (to.from_eye.z - from.from_eye.z));
  }
  return lowest > 0 && std::isfinite(lowest);
}

} // namespace

bool holds_eye(const StandingSolid& standing, const View& view) {
  std::vector<Vec3> from_eye;
  from_eye.reserve(standing.vertices_m.size());
  Box3 box;
  for (const Vec3& vertex : standing.vertices_m) {
    const ProfilePoint at = to_profile_frame(view, vertex);
    from_eye.push_back({at.u, at.v, at.z - view.eye_z_m});
    box.include(from_eye.back());
  }
  const auto spans = [](double low, double high) { return low <= 0 && high >= 0; };
  if (!spans(box.low.x, box.high.x) || !spans(box.low.y, box.high.y) ||
      !spans(box.low.z, box.high.z))
    return false;
  const double rounding_m = rounding_of_positions_m(standing, view);
  int above = 0; // triangles that the upright goes out of, less those that it goes into
  for (const auto& triangle : standing.solid->triangles) {
    Corner corners[3];
    for (std::size_t i = 0; i < 3; ++i) corners[i] = {from_eye[triangle[i]], triangle[i]};
    const auto& [a, b, c] = corners;
    const int turn = crossing(a, b) + crossing(b, c) + crossing(c, a);
    if (turn != 0 && is_above(corners, rounding_m)) above += turn;
  }
  return standing.mirrored ? above < 0 : above > 0;
}

} // namespace orograph
