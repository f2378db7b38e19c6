// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blocks/block_walk.hpp"

#include "dem/approximate/tin_of_grid.hpp"
#include "placing/vertex_values.hpp"
#include "reference/spatial.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace orograph {
namespace {

// From the point (0) towards the eye (1): to the near plane, in front of which ground is cut away,
// in perspective, without end else. An eye on the ground may be a millimetre below it.
struct Way {
  Spatial from, to_eye;
  double end;
  Spatial at(double s) const {
    return {from.u + s * to_eye.u, from.v + s * to_eye.v, from.z + s * to_eye.z};
  }
};

Way way_to_eye(const View& view, ProfilePoint p) {
  if (view.is_perspective())
    return {of(p), Spatial{0, 0, view.eye_z_m} - of(p), 1 - view.near_m / p.v};
  return {of(p), {view.x_per_v, -1, view.y_per_v / view.y_per_z}, kInfinity};
}

} // namespace

double BlockWalk::depth_inside_m(ProfilePoint point) const {
  const Way way = way_to_eye(view_, point);
  // What is this close to the point, seen from above, is at it.
  constexpr double kAtPoint_m = 1e-6;
  const double begin = kAtPoint_m / std::hypot(way.to_eye.u, way.to_eye.v);
  double deepest_m = -kInfinity;
  for (const auto& corners : triangles_) {
    const Spatial a = of(corners[0]), ab = of(corners[1]) - a, ac = of(corners[2]) - a;
    const double area = plan_cross(ab, ac);
    if (area == 0) continue;
    // Shares of the corners along the way are linear; within the triangle none is negative.
    double low = begin, high = way.end;
    const auto cut = [&](double at_0, double per_s) {
      if (per_s > 0)
        low = std::max(low, -at_0 / per_s);
      else if (per_s < 0)
        high = std::min(high, -at_0 / per_s);
      else if (at_0 < 0)
        high = -kInfinity;
    };
    const Spatial from_a = way.from - a;
    const double b_0 = plan_cross(from_a, ac) / area, b_s = plan_cross(way.to_eye, ac) / area,
                 c_0 = plan_cross(ab, from_a) / area, c_s = plan_cross(ab, way.to_eye) / area;
    cut(b_0, b_s);
    cut(c_0, c_s);
    cut(1 - b_0 - c_0, -b_s - c_s);
    if (!(low < high)) continue;
    for (const double s : {low, high})
      deepest_m =
          std::max(deepest_m, a.z + (b_0 + s * b_s) * ab.z + (c_0 + s * c_s) * ac.z - way.at(s).z);
  }
  for (const BlockWall& wall : walls_) {
    const Spatial a = of(wall.a), along = of(wall.b) - a;
    const double turn = plan_cross(way.to_eye, along);
    if (turn == 0) continue;
    const Spatial to_a = a - way.from;
    const double s = plan_cross(to_a, along) / turn, t = plan_cross(to_a, way.to_eye) / turn;
    if (!(s > begin && s < way.end && t > 0 && t < 1)) continue;
    const double z = way.at(s).z;
    const double top = std::lerp(wall.a.z, wall.b.z, t),
                 foot = std::lerp(wall.a_foot.z, wall.b_foot.z, t);
    // The surface that begins there tells how far below its edge that is.
    if (z > foot) deepest_m = std::max(deepest_m, top - z);
  }
  return deepest_m;
}

std::vector<BlockWall> walls_in(const TerrainData& terrain, const PlacedView& placed,
                                const View& view) {
  const VertexValues heights = heights_of(terrain);
  const auto place = [&](std::uint32_t number) {
    const Grid* grid = std::get_if<Grid>(&terrain.surface);
    return grid ? grid->vertex_m(number) : std::get<Tin>(terrain.surface).vertices_m[number];
  };
  const auto top = [&](std::uint32_t number) { return to_profile_frame(view, place(number)); };
  const auto foot = [&](std::uint32_t number) {
    double height_m = 0;
    heights(number, std::span(&height_m, 1));
    Vec3 at = place(number);
    at.z -= (terrain.map.earth ? terrain.map.earth->exaggeration : 1) *
            (height_m - *placed.block_base_m);
    return to_profile_frame(view, at);
  };
  std::vector<BlockWall> walls;
  for (const auto& [edge, left] : placed.border) {
    const std::uint32_t a = left ? edge.from : edge.to, b = left ? edge.to : edge.from;
    walls.push_back({top(a), top(b), foot(a), foot(b)});
  }
  return walls;
}

std::vector<std::array<ProfilePoint, 3>> triangles_in(const TerrainData& terrain,
                                                      const View& view) {
  const Grid* grid = std::get_if<Grid>(&terrain.surface);
  const Tin tin = grid ? tin_of(*grid) : std::get<Tin>(terrain.surface);
  std::vector<std::array<ProfilePoint, 3>> triangles;
  for (const auto& [a, b, c] : tin.triangles)
    triangles.push_back({to_profile_frame(view, tin.vertices_m[a]),
                         to_profile_frame(view, tin.vertices_m[b]),
                         to_profile_frame(view, tin.vertices_m[c])});
  return triangles;
}

} // namespace orograph
