// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/solid_in_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace orograph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

SolidInView in_view(const StandingSolid& standing, const View& view) {
  const Solid& solid = *standing.solid;
  SolidInView out;
  out.standing = &standing;
  double reach_m = length(view.depth_origin_m);
  for (const Vec3& vertex : standing.vertices_m) {
    const Vec3 p = as_vec(to_profile_frame(view, vertex));
    out.vertices.push_back(p);
    reach_m = std::max({reach_m, length(vertex), length(p)});
  }
  out.rounding_m = 16 * std::numeric_limits<double>::epsilon() * reach_m;
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

} // namespace orograph
