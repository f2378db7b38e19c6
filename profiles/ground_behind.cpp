// SPDX-License-Identifier: GPL-3.0-or-later
// From triangle to triangle along the ground line of a ray. A vertex is on the ray's left or on its
// right; the ray leaves a triangle over the edge between the two.
#include "profiles/ground_behind.hpp"

#include "profiles/mesh.hpp"
#include "profiles/slab_lines.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace orograph {
namespace {

// `beyond` is the side along an edge, told by its vertices on the left and on the right of the ray,
// of the triangle behind it.
// `upwards` is 1, or -1 where the surface is to come down.
template <class Mesh, class Beyond>
bool meets_ray(double upwards, const Mesh& mesh, const Beyond& beyond, const ProfileLine& line,
               SurfaceEdge edge, ProfilePoint from, double reach_m) {
  const View& view = mesh.view;
  // How far to the right of the ray a point is, in some measure.
  const auto right_of_ray = [&](ProfilePoint p) {
    return view.is_perspective() ? p.u * from.v - from.u * p.v
                                 : (p.u - from.u) + view.x_per_v * (p.v - from.v);
  };
  // Along the ray Y stays what it is.
  const double z_per_m = z_along_ray(view, from);
  // By more than rounding, which is a few ulp.
  const auto is_below_ray = [&](ProfilePoint p) {
    const double fall = (p.v - from.v) * z_per_m;
    return upwards * (p.z - from.z - fall) <
           -1e-12 * (std::abs(p.z) + std::abs(from.z) + std::abs(fall));
  };
  MeshVertex left{edge.from, line.from}, right{edge.to, line.to};
  if (right_of_ray(left.at) > right_of_ray(right.at)) std::swap(left, right);
  std::array<std::uint32_t, 3> met{};
  std::size_t count = 0;
  for (auto side = beyond(left.index, right.index); side;) {
    const auto& [triangle, k] = *side;
    const MeshVertex ahead = mesh.vertex(triangle, k);
    // Round in a circle, around a vertex by rounding or where cliffs on the ellipsoid lean over,
    // and perhaps not from the first step on: what was passed before will be again.
    const std::array present{left.index, right.index, ahead.index};
    if (present == met) return false;
    if (std::has_single_bit(++count)) met = present;
    // Of three corners one or two are on the right.
    const bool to_the_left = right_of_ray(ahead.at) > 0;
    MeshVertex& passed = to_the_left ? right : left;
    const std::uint8_t next = (k + 1) % 3, last = (k + 2) % 3;
    const std::uint8_t opposite = mesh.index(triangle, next) == passed.index ? next : last;
    passed = ahead;
    side = mesh.across({triangle, opposite});
    // Nothing of an edge that is below comes up to the ray, as nearly everywhere.
    if (is_below_ray(left.at) && is_below_ray(right.at) &&
        std::max(left.at.v, right.at.v) - from.v <= reach_m)
      continue;
    // As every point on an edge, from the vertex of lower index.
    const bool left_first = left.index < right.index;
    const ProfilePoint a = (left_first ? left : right).at, b = (left_first ? right : left).at;
    const double side_a = right_of_ray(a), side_b = right_of_ray(b);
    const double share = side_a == side_b ? 0.5 : std::clamp(side_a / (side_a - side_b), 0.0, 1.0);
    const ProfilePoint p = point_between(a, b, share);
    const double distance = p.v - from.v;
    if (distance > reach_m) return false;
    // The silhouette's own edge is in reach of rounding: a thousandth of an edge is not behind it.
    const double least_m = 1e-3 * std::max(std::abs(b.u - a.u), std::abs(b.v - a.v));
    if (distance > least_m && upwards * p.z >= upwards * (from.z + distance * z_per_m)) return true;
  }
  return false;
}

// The same on a map plane, where the lattice is alike everywhere: of two triangles at an edge the
// apexes are, added up, where its two ends are; so is all that is linear, and needn't be reckoned.
template <class Height>
bool meets_on_plane(double upwards, const Grid& grid, const Heights<Height>& heights,
                    const View& view, SurfaceEdge edge, ProfilePoint from, double reach_m) {
  struct Vertex {
    int column, row;
    double side;      // how far to the right of the ray it is, in some measure
    double u, v;      // from the ray's begin
    double above = 0; // the ray, by more than rounding
    double z = 0;
  };
  const PlaneLattice& lattice = grid.plane();
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const Height* const height = heights.data();
  const double z_per_m = z_along_ray(view, from);
  const Vec2 along_ray = view.is_perspective() ? Vec2{from.u, from.v} : Vec2{-view.x_per_v, 1};
  const bool sinks = view.drop.any();
  // False where there is no ground.
  const auto stand = [&](Vertex& p) {
    if (p.column < 0 || p.row < 0 || p.column >= grid.columns || p.row >= grid.rows) return false;
    p.z = height[grid.index(p.column, p.row)] * view.exaggeration;
    if (sinks) p.z -= view.drop.at(from.u + p.u, from.v + p.v);
    const double fall = p.v * z_per_m;
    // Rounding is a few ulp.
    p.above = upwards * (p.z - from.z - fall) +
              1e-12 * (std::abs(p.z) + std::abs(from.z) + std::abs(fall));
    return !std::isnan(p.z);
  };
  const auto place = [&](int column, int row) {
    const Vec2 at = lattice.position_m(column, row) - view.depth_origin_m;
    const Vec2 away{dot(at, view.right) - from.u, dot(at, view.forward) - from.v};
    return Vertex{column, row, cross(away, along_ray), away.x, away.y};
  };

  const auto column = static_cast<int>(edge.from % columns),
             row = static_cast<int>(edge.from / columns);
  const std::uint32_t step = edge.to - edge.from;
  const int to_column = column + (step == columns ? 0 : 1), to_row = row + (step == 1 ? 0 : 1);
  Vertex left = place(column, row), right = place(to_column, to_row);
  if (!stand(left) || !stand(right)) return false;
  const bool turned = left.side > right.side;
  if (turned) std::swap(left, right);
  // The apex on the edge's left, with columns to the east and rows to the south; and its right.
  const int left_column = column + (step == 1 ? 0 : 1), left_row = row + (step == 1         ? -1
                                                                          : step == columns ? 1
                                                                                            : 0);
  Vertex behind = turned == lattice.is_mirrored()
                      ? place(column + to_column - left_column, row + to_row - left_row)
                      : place(left_column, left_row);
  // No line passes more triangles, but one whose numbers have overflowed.
  const int most = 2 * (grid.columns + grid.rows);
  for (int passes = 0; passes < most; ++passes) {
    Vertex ahead{left.column + right.column - behind.column, left.row + right.row - behind.row,
                 left.side + right.side - behind.side, left.u + right.u - behind.u,
                 left.v + right.v - behind.v};
    if (!stand(ahead)) return false;
    // Of three corners one or two are on the right.
    Vertex& passed = ahead.side > 0 ? right : left;
    behind = passed;
    passed = ahead;
    // Nothing of an edge that is below comes up to the ray, as nearly everywhere.
    if (left.above < 0 && right.above < 0 && std::max(left.v, right.v) <= reach_m) continue;
    const double share =
        left.side == right.side ? 0.5 : std::clamp(left.side / (left.side - right.side), 0.0, 1.0);
    const double distance = left.v + share * (right.v - left.v);
    if (distance > reach_m) return false;
    // The silhouette's own edge is in reach of rounding: a thousandth of an edge is not behind it.
    const double least_m = 1e-3 * std::max(std::abs(right.u - left.u), std::abs(right.v - left.v));
    const double z = left.z + share * (right.z - left.z);
    if (distance > least_m && upwards * z >= upwards * (from.z + distance * z_per_m)) return true;
  }
  return false;
}

} // namespace

GroundBehind::GroundBehind(const Surface& surface, const View& view,
                           std::shared_ptr<const TinPlaces> of_tin)
    : surface_(surface), view_(view), of_tin_(std::move(of_tin)) {
  const Tin* tin = std::get_if<Tin>(&surface);
  if (tin && !of_tin_) of_tin_ = std::make_shared<const TinPlaces>(tin_places(*tin));
}

bool GroundBehind::meets(double upwards, SurfaceEdge edge, ProfilePoint from,
                         double reach_m) const {
  if (const Tin* tin = std::get_if<Tin>(&surface_)) {
    const auto beyond = [&](std::uint32_t left, std::uint32_t right) -> std::optional<TinSide> {
      for (const std::uint32_t t : of_tin_->at_vertex(left)) {
        const auto& corners = tin->triangles[t];
        for (std::uint8_t k = 0; k < 3; ++k)
          if (corners[(k + 1U) % 3] == left && corners[(k + 2U) % 3] == right) return TinSide{t, k};
      }
      return std::nullopt;
    };
    return meets_ray(upwards, TinMesh{*tin, view_}, beyond, line_of(*tin, view_, edge), edge, from,
                     reach_m);
  }
  const Grid& grid = std::get<Grid>(surface_);
  return std::visit(
      [&](const auto& heights) {
        if (!grid.is_on_earth())
          return meets_on_plane(upwards, grid, heights, view_, edge, from, reach_m);
        const GridMesh mesh{grid, std::get<EarthLattice>(grid.lattice), heights, view_};
        const auto beyond = [&](std::uint32_t left, std::uint32_t right) {
          return mesh.if_there(side_of(grid, edge, left < right));
        };
        return meets_ray(upwards, mesh, beyond, line_of(grid, view_, edge), edge, from, reach_m);
      },
      grid.heights_m);
}

} // namespace orograph
