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
#include <type_traits>
#include <utility>

namespace orograph {
namespace {

// How far to the right of the ray from a point another is, in some measure.
double right_of(const View& view, ProfilePoint from, ProfilePoint p) {
  return view.is_perspective() ? p.u * from.v - from.u * p.v
                               : (p.u - from.u) + view.x_per_v * (p.v - from.v);
}

// Over a TIN. Its edge at hand is told by the vertices on the left and on the right of the ray.
class TinWay {
public:
  // None begins behind an edge of the border.
  TinWay(const Tin& tin, const View& view, const TinPlaces& places, std::uint32_t left,
         std::uint32_t right)
      : mesh_{tin, view} {
    for (const std::uint32_t t : places.at_vertex(left)) {
      const auto& corners = tin.triangles[t];
      for (std::uint8_t k = 0; k < 3; ++k)
        if (corners[(k + 1U) % 3] == left && corners[(k + 2U) % 3] == right) side_ = {t, k};
    }
  }
  // The third vertex of the triangle behind the edge, if there is one.
  std::optional<MeshVertex> ahead() const {
    if (!side_) return std::nullopt;
    return mesh_.vertex(side_->triangle, side_->k);
  }
  // On over the edge between that one and the one on the right, or on the left.
  void go_on(bool beside_right) {
    const auto next = static_cast<std::uint8_t>((side_->k + (beside_right ? 1U : 2U)) % 3);
    side_ = mesh_.across({side_->triangle, next});
  }

private:
  TinMesh mesh_;
  std::optional<TinSide> side_;
};

// The same over a lattice, where the two triangles at an edge make a parallelogram: the vertex
// beyond the edge is left + right - (the one behind).
template <class Height>
class LatticeWay {
public:
  LatticeWay(const Grid& grid, const Heights<Height>& heights, const View& view,
             SurfaceEdge from_to, bool from_is_left)
      : grid_(grid), heights_(heights), view_(view) {
    const GridSide side = side_of(grid, from_to, from_is_left);
    const auto corner = [&](std::size_t n) {
      const auto& [column, row, half] = side.triangle;
      const grid_mesh::Offset offset =
          grid_mesh::kCorners[static_cast<int>(half)][(side.k + n) % 3];
      return CellVertex{column + offset.column, row + offset.row};
    };
    ahead_ = corner(0);
    left_ = corner(1);
    right_ = corner(2);
  }
  std::optional<MeshVertex> ahead() const {
    const auto [column, row] = ahead_;
    if (column < 0 || row < 0 || column >= grid_.columns || row >= grid_.rows) return std::nullopt;
    const std::size_t index = grid_.index(column, row);
    const double height = heights_[index];
    if (std::isnan(height)) return std::nullopt;
    return MeshVertex{static_cast<std::uint32_t>(index),
                      to_profile_frame(view_, grid_.earth().vertex_m(column, row, height))};
  }
  void go_on(bool beside_right) {
    CellVertex& passed = beside_right ? left_ : right_;
    const CellVertex behind = std::exchange(passed, ahead_);
    ahead_ = {left_.column + right_.column - behind.column, left_.row + right_.row - behind.row};
  }

private:
  const Grid& grid_;
  const Heights<Height>& heights_;
  const View& view_;
  CellVertex left_, right_, ahead_;
};

// From an edge, by its vertices on the left and on the right of the ray, on along a way over the
// surface. `upwards` is 1, or -1 where the surface is to come down.
template <class Way>
bool meets_ray(double upwards, const View& view, MeshVertex left, MeshVertex right, Way way,
               ProfilePoint from, double reach_m) {
  const auto right_of_ray = [&](ProfilePoint p) { return right_of(view, from, p); };
  // Along the ray Y stays what it is.
  const double z_per_m = z_along_ray(view, from);
  // By more than rounding, which is a few ulp.
  const auto is_below_ray = [&](ProfilePoint p) {
    const double fall = (p.v - from.v) * z_per_m;
    return upwards * (p.z - from.z - fall) <
           -1e-12 * (std::abs(p.z) + std::abs(from.z) + std::abs(fall));
  };
  bool left_is_below = is_below_ray(left.at), right_is_below = is_below_ray(right.at);
  // Three corners met before, one by one: in an array they would wait for each other's storing.
  std::uint32_t met_left = 0, met_right = 0, met_ahead = 0;
  std::size_t count = 0;
  while (const std::optional<MeshVertex> ahead = way.ahead()) {
    // Round in a circle, around a vertex by rounding or where cliffs on the ellipsoid lean over,
    // and perhaps not from the first step on: what was passed before will be again.
    if (left.index == met_left && right.index == met_right && ahead->index == met_ahead)
      return false;
    if (std::has_single_bit(++count)) {
      met_left = left.index;
      met_right = right.index;
      met_ahead = ahead->index;
    }
    // Of three corners one or two are on the right.
    const bool is_right = right_of_ray(ahead->at) > 0;
    (is_right ? right : left) = *ahead;
    (is_right ? right_is_below : left_is_below) = is_below_ray(ahead->at);
    way.go_on(!is_right);
    // Nothing of an edge that is below comes up to the ray, as nearly everywhere.
    if (left_is_below && right_is_below && std::max(left.at.v, right.at.v) - from.v <= reach_m)
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

// The rows, the columns or the diagonals of a lattice on a map plane. A diagonal has the number of
// the column in which it meets row 0.
struct LineFamily {
  std::ptrdiff_t of_line, of_edge; // what a vertex's index grows by
  int last;                        // vertex of a line; of line 0, where they are diagonals
  bool are_diagonals;
  int last_row;
  double least_m; // a thousandth of an edge
  double bend_m;  // four times what an edge's ends sink more than its middle would

  int first_of(int line) const { return are_diagonals ? std::max(0, line) : 0; }
  int last_of(int line) const { return are_diagonals ? std::min(last, last_row + line) : last; }
};

// How a ray goes on among the lines of a family, of which it passes one after another at equal
// steps.
struct WayAcross {
  double lines_per_m, m_per_line, edges_per_m; // along a line it goes on by edges
};

// Where a ray goes, for each metre of depth.
struct WayOfRay {
  double u_per_m, z_per_m;
  Vec2 cells_per_m;
  double most_per_m; // of the two, without their signs
  std::array<WayAcross, 3> across;
};

} // namespace

// On a map plane nothing has to be walked: what a ray passes can be reckoned.
class GroundBehind::OnPlane {
public:
  OnPlane(const Grid& grid, const View& view)
      : view_(view), last_column_(grid.columns - 1), last_row_(grid.rows - 1) {
    const auto& [first_vertex_m, column_step_m, row_step_m] = grid.plane();
    column_step_m_ = column_step_m;
    row_step_m_ = row_step_m;
    area_ = cross(column_step_m, row_step_m);
    first_vertex_m_ = first_vertex_m;
    const auto family = [&](Vec2 edge_m, std::ptrdiff_t of_line, std::ptrdiff_t of_edge, int last,
                            bool are_diagonals) {
      const double u = dot(edge_m, view.right), v = dot(edge_m, view.forward);
      const double least_m = 1e-3 * std::max(std::abs(u), std::abs(v));
      return LineFamily{of_line, of_edge,           last, are_diagonals, last_row_,
                        least_m, view.drop.at(u, v)};
    };
    const int columns = grid.columns;
    families_ = {family(column_step_m, columns, 1, last_column_, false),
                 family(row_step_m, 1, columns, last_row_, false),
                 family(column_step_m + row_step_m, -columns, columns + 1, last_column_, true)};
    if (!view.is_perspective()) parallel_ = way_from({});
  }

  template <class Height>
  bool meets(double upwards, const Heights<Height>& heights, ProfilePoint from,
             double reach_m) const {
    return parallel_ ? meets(upwards, heights, from, reach_m, *parallel_)
                     : meets(upwards, heights, from, reach_m, way_from(from));
  }

private:
  // By divisions, so that whole cells are whole: level rays over ground of whole metres meet what
  // is just as high.
  Vec2 in_cells(Vec2 m) const {
    return {cross(m, row_step_m_) / area_, cross(column_step_m_, m) / area_};
  }

  WayOfRay way_from(ProfilePoint from) const {
    const double u_per_m = u_along_ray(view_, from);
    const Vec2 per_m = in_cells(view_.forward + u_per_m * view_.right);
    const auto across = [](double lines, double edges) {
      return WayAcross{lines, 1 / lines, edges};
    };
    return {
        u_per_m,
        z_along_ray(view_, from),
        per_m,
        std::max(std::abs(per_m.x), std::abs(per_m.y)),
        {across(per_m.y, per_m.x), across(per_m.x, per_m.y), across(per_m.x - per_m.y, per_m.x)}};
  }

  template <class Height>
  bool meets(double upwards, const Heights<Height>& heights, ProfilePoint from, double reach_m,
             const WayOfRay& way) const {
    const Vec2 ground_m = view_.depth_origin_m + from.u * view_.right + from.v * view_.forward;
    const Vec2 begin = in_cells(ground_m - first_vertex_m_);
    // False where numbers have overflowed as well.
    const auto is_inside = [](double at, int last) { return at > -0.5 && at < last + 0.5; };
    if (!is_inside(begin.x, last_column_) || !is_inside(begin.y, last_row_) ||
        !std::isfinite(way.most_per_m))
      return false;
    // Where the ray leaves the lattice, by a little more than rounding.
    constexpr double kRounding = 1e-6; // of a cell
    const auto border_m = [](double at, int last, const WayAcross& across) {
      if (across.lines_per_m == 0) return std::numeric_limits<double>::infinity();
      return ((across.lines_per_m > 0 ? last + kRounding : -kRounding) - at) * across.m_per_line;
    };
    const double end_m = std::min({reach_m, border_m(begin.x, last_column_, way.across[1]),
                                   border_m(begin.y, last_row_, way.across[0])});

    struct Place {
      double line, edge; // where the ray begins, and where on that line
      int next;          // line that it passes
    };
    const auto place = [&](std::size_t family, double line, double edge) {
      return Place{line, edge,
                   static_cast<int>(way.across[family].lines_per_m > 0 ? std::floor(line) + 1
                                                                       : std::ceil(line) - 1)};
    };
    std::array<Place, 3> places{place(0, begin.y, begin.x), place(1, begin.x, begin.y),
                                place(2, begin.x - begin.y, begin.x)};
    // The ray's height above ground that hasn't sunk, k0 + k1 * m + k2 * m * m, and which side of
    // it is asked for.
    const auto& [uu, uv, vv] = view_.drop;
    const double u = from.u, v = from.v, u_per_m = way.u_per_m,
                 k0 = upwards * (from.z + view_.drop.at(u, v)),
                 k1 = upwards *
                      (way.z_per_m + 2 * uu * u * u_per_m + uv * (u + v * u_per_m) + 2 * vv * v),
                 k2 = upwards * (uu * u_per_m * u_per_m + uv * u_per_m + vv),
                 per_height = upwards * view_.exaggeration;

    // Calls take(m, lines, ground, ray) with where the ray passes lines of a family and isn't above
    // the ground, up to a depth that may get less meanwhile, and with both heights, until that
    // returns true. All lines that it passes have edges there if it keeps away from the border.
    const Vec2 end = begin + end_m * way.cells_per_m;
    const auto keeps_away = [](double a, double b, int last) {
      return std::min(a, b) > 1 && std::max(a, b) < last - 1;
    };
    const bool is_inside_by_far =
        keeps_away(begin.x, end.x, last_column_) && keeps_away(begin.y, end.y, last_row_);
    const auto pass = [&](std::size_t i, const double& to_m, auto inside, const auto& take) {
      const LineFamily& lines = families_[i];
      const WayAcross& across = way.across[i];
      Place& at = places[i];
      for (const int step = across.lines_per_m > 0 ? 1 : -1;; at.next += step) {
        const double m = (at.next - at.line) * across.m_per_line;
        if (!(m <= to_m)) return;
        const double along = at.edge + m * across.edges_per_m;
        int edge = static_cast<int>(along);
        if constexpr (!inside) {
          const int first = lines.first_of(at.next), last = lines.last_of(at.next);
          if (first >= last) continue; // the lattice's corner
          edge = std::clamp(edge, first, last - 1);
        }
        const double share = along - edge;
        const Height* const height =
            heights.data() + at.next * lines.of_line + edge * lines.of_edge;
        const double ground =
            per_height *
                (height[0] + share * (static_cast<double>(height[lines.of_edge]) - height[0])) -
            share * (1 - share) * (upwards * lines.bend_m);
        const double ray = k0 + m * (k1 + m * k2);
        if (ground < ray) continue; // as nearly everywhere
        if (take(m, lines, ground, ray)) return;
      }
    };

    // What is met first decides, so all three go on by some cells at once.
    constexpr double kCellsAtOnce = 8;
    for (double to_m = 0; to_m < end_m;) {
      to_m = std::min(to_m + kCellsAtOnce / way.most_per_m, end_m);
      double met_m = to_m;
      std::optional<bool> meets;
      const auto take = [&](double m, const LineFamily& lines, double ground, double ray) {
        const bool is_ground = !std::isnan(ground);
        // The silhouette's own edge is in reach of rounding: a thousandth of an edge is not behind
        // it.
        if (is_ground && !(m > lines.least_m && ground >= ray)) return false;
        met_m = m;
        meets = is_ground;
        return true;
      };
      for (std::size_t i = 0; i < families_.size(); ++i) {
        if (way.across[i].lines_per_m == 0) continue;
        if (is_inside_by_far)
          pass(i, met_m, std::true_type(), take);
        else
          pass(i, met_m, std::false_type(), take);
      }
      if (meets) return *meets;
    }
    return false;
  }

  const View& view_;
  int last_column_, last_row_;
  Vec2 first_vertex_m_, column_step_m_, row_step_m_;
  double area_;                        // of a cell, with its sign
  std::array<LineFamily, 3> families_; // rows, columns, diagonals
  std::optional<WayOfRay> parallel_;   // of all rays, where they are parallel
};

GroundBehind::GroundBehind(const Surface& surface, const View& view,
                           std::shared_ptr<const TinPlaces> of_tin)
    : surface_(surface), view_(view), ends_(surface, view), of_tin_(std::move(of_tin)) {
  const Tin* tin = std::get_if<Tin>(&surface);
  if (tin && !of_tin_) of_tin_ = std::make_shared<const TinPlaces>(tin_places(*tin));
  if (const Grid* grid = std::get_if<Grid>(&surface); grid && !grid->is_on_earth())
    on_plane_ = std::make_shared<const OnPlane>(*grid, view);
}

bool GroundBehind::meets(double upwards, SurfaceEdge edge, ProfilePoint from,
                         double reach_m) const {
  const Grid* const grid = std::get_if<Grid>(&surface_);
  if (on_plane_)
    return std::visit(
        [&](const auto& heights) { return on_plane_->meets(upwards, heights, from, reach_m); },
        grid->heights_m);
  const ProfileLine line = ends_(edge);
  const bool from_is_left = right_of(view_, from, line.from) <= right_of(view_, from, line.to);
  const MeshVertex one{edge.from, line.from}, other{edge.to, line.to},
      left = from_is_left ? one : other, right = from_is_left ? other : one;
  if (const Tin* tin = std::get_if<Tin>(&surface_))
    return meets_ray(upwards, view_, left, right,
                     TinWay(*tin, view_, *of_tin_, left.index, right.index), from, reach_m);
  return std::visit(
      [&](const auto& heights) {
        return meets_ray(upwards, view_, left, right,
                         LatticeWay(*grid, heights, view_, edge, from_is_left), from, reach_m);
      },
      grid->heights_m);
}

} // namespace orograph
