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
#include <limits>
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

// The rows, the columns or the diagonals of a lattice on a map plane, which a ray passes at equal
// steps. A diagonal has the number of the column in which it meets row 0.
struct LinesPassed {
  double begin, per_m;             // which line the ray is at, and by how many it goes on
  double begin_along, along_per_m; // where on that line, in edges
  Vec2 edge;                       // in the profile frame
  std::ptrdiff_t of_line, of_edge; // what a vertex's index grows by
  int first, last;                 // vertices of a line; of line 0, where they are diagonals
  bool are_diagonals;
  int last_row;

  int first_of(int line) const { return are_diagonals ? std::max(first, line) : first; }
  int last_of(int line) const { return are_diagonals ? std::min(last, last_row + line) : last; }
};

// The same on a map plane, where nothing has to be walked: what the ray passes can be reckoned.
template <class Height>
bool meets_on_plane(double upwards, const Grid& grid, const Heights<Height>& heights,
                    const View& view, ProfilePoint from, double reach_m) {
  const auto& [first_vertex_m, column_step_m, row_step_m] = grid.plane();
  const auto in_cells = [&, area = cross(column_step_m, row_step_m)](Vec2 m) {
    return Vec2{cross(m, row_step_m) / area, cross(column_step_m, m) / area};
  };
  const double u_per_m = u_along_ray(view, from), z_per_m = z_along_ray(view, from);
  const Vec2 ground_m = view.depth_origin_m + from.u * view.right + from.v * view.forward;
  const Vec2 begin = in_cells(ground_m - first_vertex_m),
             per_m = in_cells(view.forward + u_per_m * view.right);
  const int columns = grid.columns, last_column = columns - 1, last_row = grid.rows - 1;

  // Where the ray leaves the lattice, by a little more than rounding.
  constexpr double kRounding = 1e-6; // of a cell
  const auto border_m = [](double at, double at_per_m, int last) {
    if (at_per_m == 0) return std::numeric_limits<double>::infinity();
    return ((at_per_m > 0 ? last : 0) - at) / at_per_m + kRounding / std::abs(at_per_m);
  };
  const double end_m = std::min(
      {reach_m, border_m(begin.x, per_m.x, last_column), border_m(begin.y, per_m.y, last_row)});
  const double most_per_m = std::max(std::abs(per_m.x), std::abs(per_m.y));
  // False where numbers have overflowed as well.
  const auto is_inside = [](double at, int last) { return at > -0.5 && at < last + 0.5; };
  if (!is_inside(begin.x, last_column) || !is_inside(begin.y, last_row) ||
      !std::isfinite(most_per_m))
    return false;

  const auto in_frame = [&](Vec2 m) { return Vec2{dot(m, view.right), dot(m, view.forward)}; };
  const std::array<LinesPassed, 3> families{
      {{begin.y, per_m.y, begin.x, per_m.x, in_frame(column_step_m), columns, 1, 0, last_column,
        false, last_row},
       {begin.x, per_m.x, begin.y, per_m.y, in_frame(row_step_m), 1, columns, 0, last_row, false,
        last_row},
       {begin.x - begin.y, per_m.x - per_m.y, begin.x, per_m.x,
        in_frame(column_step_m + row_step_m), -columns, columns + 1, 0, last_column, true,
        last_row}}};
  std::array<int, 3> next{};
  for (std::size_t i = 0; i < families.size(); ++i)
    next[i] = static_cast<int>(families[i].per_m > 0 ? std::floor(families[i].begin) + 1
                                                     : std::ceil(families[i].begin) - 1);

  // What is met first decides, so all three go on by some cells at once.
  constexpr double kCellsAtOnce = 8;
  for (double to_m = 0; to_m < end_m;) {
    to_m = std::min(to_m + kCellsAtOnce / most_per_m, end_m);
    double met_m = to_m;
    std::optional<bool> meets;
    for (std::size_t i = 0; i < families.size(); ++i) {
      const LinesPassed& lines = families[i];
      if (lines.per_m == 0) continue;
      const double m_per_line = 1 / lines.per_m;
      const double least_m = 1e-3 * std::max(std::abs(lines.edge.x), std::abs(lines.edge.y));
      const double bend_m = view.drop.at(lines.edge.x, lines.edge.y);
      for (int& line = next[i];; line += lines.per_m > 0 ? 1 : -1) {
        const double m = (line - lines.begin) * m_per_line;
        if (!(m <= met_m)) break;
        const int first = lines.first_of(line), last = lines.last_of(line);
        if (first >= last) continue; // the lattice's corner
        const double along = lines.begin_along + m * lines.along_per_m;
        const int edge = std::clamp(static_cast<int>(along), first, last - 1);
        const double share = along - edge;
        const Height* const at = heights.data() + line * lines.of_line + edge * lines.of_edge;
        const double height = at[0] + share * (static_cast<double>(at[lines.of_edge]) - at[0]);
        // An edge is straight between its ends, which sink more than what is between them would.
        const double drop =
            view.drop.at(from.u + m * u_per_m, from.v + m) + share * (1 - share) * bend_m;
        const double z = height * view.exaggeration - drop;
        const bool is_ground = !std::isnan(height);
        // The silhouette's own edge is in reach of rounding: a thousandth of an edge is not behind
        // it.
        if (is_ground && !(m > least_m && upwards * z >= upwards * (from.z + m * z_per_m)))
          continue;
        met_m = m;
        meets = is_ground;
        break;
      }
    }
    if (meets) return *meets;
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
          return meets_on_plane(upwards, grid, heights, view_, from, reach_m);
        const GridMesh mesh{grid, std::get<EarthLattice>(grid.lattice), heights, view_};
        const auto beyond = [&](std::uint32_t left, std::uint32_t right) {
          return mesh.if_there(side_of(grid, edge, left < right));
        };
        return meets_ray(upwards, mesh, beyond, line_of(grid, view_, edge), edge, from, reach_m);
      },
      grid.heights_m);
}

} // namespace orograph
