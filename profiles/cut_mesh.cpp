// SPDX-License-Identifier: GPL-3.0-or-later
// A walk from triangle to triangle, as over a grid (walk_grid.cpp): a vertex is *near* if its depth
// is less than the plane's, otherwise *far*, and the plane crosses the edges between a near and a
// far vertex. A walk begins at a border edge over which the plane comes in, and ends at another.
// Each walk is a run of vertices; runs are put in order of u. Where a part of a profile is asked
// for, walks begin as well at the sides of a few cells about its left end, and end beyond its right
// one.
#include "profiles/cut_mesh.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/facing.hpp"
#include "profiles/profile.hpp"
#include "profiles/surface_edges.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace orograph {
namespace {

// One walk's vertices, [begin, end) of those found.
struct Run {
  std::size_t begin, end;
  double u_first, u_last;
  bool along; ///< a border edge in the plane, with nothing in front of it
};

// Takes away border edges in the plane that lie where there is ground in front of it as well: a
// wall is missing between the two.
void keep_ground_in_front(std::vector<Run>& runs) {
  std::vector<Run> through;
  for (const Run& run : runs)
    if (!run.along) through.push_back(run);
  std::sort(through.begin(), through.end(),
            [](const Run& a, const Run& b) { return a.u_last < b.u_last; });
  std::erase_if(runs, [&](const Run& run) {
    if (!run.along) return false;
    const auto next = std::partition_point(through.begin(), through.end(), [&](const Run& other) {
      return other.u_last <= run.u_first;
    });
    return next != through.end() && next->u_first < run.u_last;
  });
}

// The runs of `from`, in order and joined where one ends at the vertex at which the next begins.
void put_in_order(const Profile& from, std::vector<Run>& runs, Profile& out) {
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return a.u_first != b.u_first ? a.u_first < b.u_first : a.u_last < b.u_last;
  });
  for (const Run& run : runs) {
    std::size_t i = run.begin;
    if (out.size() > 0) {
      if (run.u_last <= out.u_m.back() && run.u_first < out.u_m.back()) continue;
      if (from.u_m[i] == out.u_m.back() && from.z_m[i] == out.z_m.back()) {
        out.after.back() = from.after[i];
        ++i;
      }
    }
    for (; i < run.end; ++i) {
      const double u = from.u_m[i];
      out.u_m.push_back(out.size() > 0 ? std::max(u, out.u_m.back()) : u);
      out.z_m.push_back(from.z_m[i]);
      out.after.push_back(from.after[i]);
    }
  }
}

// A Mesh has triangles whose corners run counterclockwise seen from above, and
//   Side               {triangle, k}: the side of a triangle opposite to its corner k
//   vertex(t, k)       a triangle's corner, a MeshVertex
//   across(side)       the same side of the triangle beyond it; none at the border
//   span_in(t)         what the triangle holds of the surface
//   is_wall(t)
template <class Mesh>
class MeshWalk {
public:
  using Side = typename Mesh::Side;

  // Walks go on to the first vertex beyond `high_m`.
  MeshWalk(const Mesh& mesh, double depth_m, double high_m, bool far_at_plane, Profile& out)
      : mesh_(mesh), depth_m_(depth_m), high_m_(high_m), far_at_plane_(far_at_plane), out_(out) {}

  // The run that begins at a side of the border, if there is one; it is appended to `out`.
  std::optional<Run> from(const Side& side) {
    const std::size_t begin = out_.size();
    bool along = false;
    const MeshVertex from = corner(side, 1), to = corner(side, 2);
    if (is_far(from) && !is_far(to))
      run(side, from, to);
    else if (from.at.v == depth_m_ && to.at.v == depth_m_ &&
             is_far(corner(side, 0)) == is_far(from)) {
      run_along(side, from.at, to.at);
      along = true;
    }
    return found_from(begin, along);
  }

  // The same over a side with triangles on both sides of it.
  std::optional<Run> over(const Side& side) {
    const std::size_t begin = out_.size();
    const MeshVertex from = corner(side, 1), to = corner(side, 2);
    if (is_far(from) && !is_far(to)) run(side, from, to);
    return found_from(begin, false);
  }

  // Whether a side reaches into a part of the profile.
  bool reaches_into(const Side& side, URange part) const {
    const double a = corner(side, 1).at.u, b = corner(side, 2).at.u;
    return std::max(a, b) >= part.low_m && std::min(a, b) <= part.high_m;
  }

private:
  std::optional<Run> found_from(std::size_t begin, bool along) const {
    if (out_.size() <= begin + 1) return std::nullopt;
    return Run{begin, out_.size(), out_.u_m[begin], out_.u_m.back(), along};
  }
  MeshVertex corner(const Side& side, std::size_t n) const {
    return mesh_.vertex(side.triangle, (side.k + n) % 3);
  }
  bool is_far(const MeshVertex& p) const {
    return far_at_plane_ ? p.at.v >= depth_m_ : p.at.v > depth_m_;
  }

  void add(double u, double z, Span before, std::size_t begin) {
    if (out_.size() > begin) {
      // Around a vertex in the plane all edges cross at that vertex: it is there once, and the
      // triangles that only touch it don't matter.
      if (u == out_.u_m.back() && z == out_.z_m.back()) return;
      out_.after.back() = before;
      // Crossings an ulp apart may round to the wrong order, and a wall's differ by as much.
      u = before == Span::wall ? out_.u_m.back() : std::max(u, out_.u_m.back());
    }
    out_.u_m.push_back(u);
    out_.z_m.push_back(z);
    out_.after.push_back(Span::gap);
  }

  void add_crossing(const MeshVertex& near, const MeshVertex& far, Span before, std::size_t begin) {
    const bool near_first = near.index < far.index;
    const ProfilePoint a = near_first ? near.at : far.at, b = near_first ? far.at : near.at;
    const double t = (depth_m_ - a.v) / (b.v - a.v);
    double u = a.u + t * (b.u - a.u), z = a.z + t * (b.z - a.z);
    if (t >= 1) u = b.u, z = b.z;
    if (t <= 0) u = a.u, z = a.z;
    add(u, z, before, begin);
  }

  // What the plane meets on its way through a triangle, from its side near-far to `ahead`.
  Span span_of(const Side& side, const MeshVertex& near, const MeshVertex& far,
               const MeshVertex& ahead) const {
    const Span span = mesh_.span_in(side.triangle);
    // An edge in the plane belongs to the triangle on its other side as well.
    const MeshVertex& on_plane = far_at_plane_ ? far : near;
    if (on_plane.at.v != depth_m_ || ahead.at.v != depth_m_) return span;
    const auto other = mesh_.across(
        {side.triangle, static_cast<std::uint8_t>((side.k + (far_at_plane_ ? 2 : 1)) % 3)});
    if (!other || mesh_.is_wall(other->triangle)) return span;
    const Span beyond = mesh_.span_in(other->triangle);
    return mesh_.is_wall(side.triangle) ? beyond : std::max(span, beyond);
  }

  // From a side of the border inwards.
  void run(Side side, MeshVertex far, MeshVertex near) {
    const std::size_t begin = out_.size();
    add_crossing(near, far, Span::gap, begin);
    for (;;) {
      const MeshVertex ahead = corner(side, 0);
      const Span span = span_of(side, near, far, ahead);
      const bool leaves_beside_near = is_far(ahead);
      (leaves_beside_near ? far : near) = ahead;
      add_crossing(near, far, span, begin);
      if (out_.u_m.back() > high_m_) return;
      side.k = static_cast<std::uint8_t>((side.k + (leaves_beside_near ? 1 : 2)) % 3);
      const auto next = mesh_.across(side);
      if (!next) return;
      side = *next;
    }
  }

  // A border edge that lies in the plane, with nothing in front of it.
  void run_along(const Side& side, ProfilePoint left, ProfilePoint right) {
    const std::size_t begin = out_.size();
    if (left.u > right.u) std::swap(left, right);
    add(left.u, left.z, Span::gap, begin);
    add(right.u, right.z, mesh_.is_wall(side.triangle) ? Span::slope : mesh_.span_in(side.triangle),
        begin);
  }

  const Mesh& mesh_;
  double depth_m_, high_m_;
  bool far_at_plane_; ///< whether a vertex in the plane counts as far
  Profile& out_;      ///< of one run after the other
};

// The profile of a mesh at a depth.
template <class Mesh>
void cut_mesh(const Mesh& mesh, const BorderSides<typename Mesh::Side>& border, double depth_m,
              bool far_at_plane, Profile& out) {
  Profile found;
  std::vector<Run> runs;
  MeshWalk<Mesh> walk(mesh, depth_m, URange{}.high_m, far_at_plane, found);
  for (const auto& side : border.at(depth_m))
    if (const auto run = walk.from(side)) runs.push_back(*run);
  keep_ground_in_front(runs);
  put_in_order(found, runs, out);
}

struct CutTinMesh : TinMesh {
  const TriangleSet &level, &walls, &turned_walls;

  bool is_wall(std::uint32_t t) const { return !walls.empty() && walls.has(t); }
  Span span_in(std::uint32_t t) const {
    if (is_wall(t)) return turned_walls.has(t) ? Span::gap : Span::wall;
    return !level.empty() && level.has(t) ? Span::level : Span::slope;
  }
};

std::vector<TinSide> border_of(const Tin& tin) {
  std::vector<TinSide> border;
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    for (std::uint8_t k = 0; k < 3; ++k)
      if (tin.neighbours[t][k] == kNoTriangle) border.push_back({t, k});
  }
  return border;
}

} // namespace

TinCutter::TinCutter(const Tin& tin, const View& view, const TriangleSet& level)
    : tin_(tin), view_(view), level_(level), nearest_m_(std::numeric_limits<double>::infinity()),
      farthest_m_(-nearest_m_), walls_(walls_of(tin)),
      border_(border_of(tin), [&](const TinSide& side) {
        const auto depth = [&](std::size_t n) {
          return to_profile_frame(view,
                                  tin.vertices_m[tin.triangles[side.triangle][(side.k + n) % 3]])
              .v;
        };
        const double a = depth(1), b = depth(2);
        return BorderSides<TinSide>::Depths{std::min(a, b), std::max(a, b)};
      }) {
  std::size_t step = 0;
  for (const Vec3& vertex : tin.vertices_m) {
    throw_if_stopped(step++);
    const double v = to_profile_frame(view, vertex).v;
    nearest_m_ = std::min(nearest_m_, v);
    farthest_m_ = std::max(farthest_m_, v);
  }
  if (walls_.empty()) return;
  turned_walls_ = TriangleSet(tin.triangles.size());
  const std::vector<std::uint8_t> facing = facing_of_triangles(tin, view);
  for (std::size_t t = 0; t < facing.size(); ++t)
    if (walls_.has(t) && (facing[t] & kMayTurn)) turned_walls_.add(t); // edge-on, too
}

void TinCutter::cut(double depth_m, Profile& out) const {
  out.clear();
  out.depth_m = depth_m;
  if (!(depth_m >= nearest_m_ && depth_m <= farthest_m_)) return;
  // Vertices in the plane count as far, except where the TIN only touches the plane from behind:
  // then nothing would be near.
  cut_mesh(CutTinMesh{{tin_, view_}, level_, walls_, turned_walls_}, border_, depth_m,
           depth_m > nearest_m_, out);
}

namespace {

template <class Height>
struct CutEarthMesh : GridMesh<EarthLattice, Height> {
  const TriangleSet& level;

  bool is_wall(const CellHalf&) const { return false; }
  Span span_in(const CellHalf& t) const {
    return !level.empty() && level.has(grid_triangle(this->grid, t.column, t.row, t.half))
               ? Span::level
               : Span::slope;
  }
};

BorderSides<GridSide> sides_of(const Grid& grid, const View& view,
                               std::span<const BorderEdge> border) {
  std::vector<GridSide> sides;
  sides.reserve(border.size());
  for (const auto& [edge, left] : border) sides.push_back(side_of(grid, edge, left));
  return std::visit(
      [&](const auto& heights) {
        const GridMesh mesh{grid, grid.earth(), heights, view};
        return BorderSides<GridSide>(sides, [&](const GridSide& side) {
          const double a = mesh.vertex(side.triangle, (side.k + 1U) % 3).at.v,
                       b = mesh.vertex(side.triangle, (side.k + 2U) % 3).at.v;
          return BorderSides<GridSide>::Depths{std::min(a, b), std::max(a, b)};
        });
      },
      grid.heights_m);
}

// Cells, the last ones included; none where first is greater than last.
struct CellBox {
  int first_column, last_column, first_row, last_row;

  bool has(const CellHalf& t) const {
    return t.column >= first_column && t.column <= last_column && t.row >= first_row &&
           t.row <= last_row;
  }
};

// Calls take(side) with the sides about a box, by the triangles in it.
template <class Take>
void for_each_side_about(const CellBox& box, const Take& take) {
  for (int column = box.first_column; column <= box.last_column; ++column) {
    take(GridSide{{column, box.first_row, Half::upper}, 1});
    take(GridSide{{column, box.last_row, Half::lower}, 0});
  }
  for (int row = box.first_row; row <= box.last_row; ++row) {
    take(GridSide{{box.first_column, row, Half::lower}, 2});
    take(GridSide{{box.last_column, row, Half::upper}, 0});
  }
}

// Among them is any that holds a place of a profile, between two z: uprights lean against one
// another, so that the ground at a place may belong to any cell below one of its heights. A
// triangle is flat, and leaves its cell by less than a cell.
CellBox cells_about(const Grid& grid, const View& view, ProfilePoint place, double low_z_m,
                    double high_z_m) {
  const EarthLattice& lattice = grid.earth();
  const Vec2 at = view.depth_origin_m + place.u * view.right + place.v * view.forward;
  const Vec2 low = lattice.column_row_at({at.x, at.y, low_z_m}),
             high = lattice.column_row_at({at.x, at.y, high_z_m});
  const auto whole = [](double cell, int count) {
    return static_cast<int>(std::clamp(std::floor(cell), -2.0, count + 1.0));
  };
  return {std::max(whole(std::min(low.x, high.x), grid.columns) - 1, 0),
          std::min(whole(std::max(low.x, high.x), grid.columns) + 1, grid.columns - 2),
          std::max(whole(std::min(low.y, high.y), grid.rows) - 1, 0),
          std::min(whole(std::max(low.y, high.y), grid.rows) + 1, grid.rows - 2)};
}

// Whether a place has one column, and near enough a straight way from one height to the other.
bool is_plain(const DegreeLattice& degrees) {
  const double from_deg = degrees.lat_deg(0), to_deg = degrees.lat_deg(degrees.rows - 1);
  return std::abs(degrees.lon_step_deg) * degrees.columns < 180 &&
         std::max(std::abs(from_deg), std::abs(to_deg)) < 85;
}

// A part of the profile of a grid.
template <class Mesh>
void cut_part(const Mesh& mesh, const BorderSides<GridSide>& border, const CellBox& left_end,
              URange part, double depth_m, bool far_at_plane, Profile& out) {
  Profile found;
  std::vector<Run> runs;
  MeshWalk<Mesh> walk(mesh, depth_m, part.high_m, far_at_plane, found);
  const auto add = [&](const std::optional<Run>& run) {
    if (run) runs.push_back(*run);
  };
  for_each_side_about(left_end, [&](const GridSide& side) {
    const auto [column, row] = mesh.corner(side.triangle, (side.k + 2U) % 3);
    const bool ends = std::isnan(mesh.heights[mesh.grid.index(column, row)]);
    // Where there is nothing beyond it, it is of the border.
    if (!ends && mesh.if_there(side) && mesh.across(side)) add(walk.over(side));
  });
  for (const GridSide& side : border.at(depth_m))
    if (left_end.has(side.triangle) || walk.reaches_into(side, part)) add(walk.from(side));
  keep_ground_in_front(runs);
  put_in_order(found, runs, out);
}

} // namespace

EarthGridCutter::EarthGridCutter(const Grid& grid, const View& view, const TriangleSet& level,
                                 std::span<const BorderEdge> border, const Box3* box)
    : grid_(grid), view_(view), level_(level), border_(sides_of(grid, view, border)) {
  if (box && is_plain(grid.earth().degrees())) z_m_ = {box->low.z, box->high.z};
}

void EarthGridCutter::cut(double depth_m, std::span<const URange> ranges, Profile& out) const {
  const URange part{ranges.front().low_m, ranges.back().high_m};
  if (!z_m_ || !std::isfinite(part.low_m)) {
    cut(depth_m, out);
    return;
  }
  out.clear();
  out.depth_m = depth_m;
  if (!(depth_m >= nearest_m() && depth_m <= farthest_m())) return;
  const CellBox left_end =
      cells_about(grid_, view_, {part.low_m, depth_m, 0}, z_m_->low_m, z_m_->high_m);
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        cut_part(CutEarthMesh<Height>{{grid_, grid_.earth(), heights, view_}, level_}, border_,
                 left_end, part, depth_m, depth_m > nearest_m(), out);
      },
      grid_.heights_m);
}

void EarthGridCutter::cut(double depth_m, Profile& out) const {
  out.clear();
  out.depth_m = depth_m;
  if (!(depth_m >= nearest_m() && depth_m <= farthest_m())) return;
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        cut_mesh(CutEarthMesh<Height>{{grid_, grid_.earth(), heights, view_}, level_}, border_,
                 depth_m, depth_m > nearest_m(), out);
      },
      grid_.heights_m);
}

} // namespace orograph
