// SPDX-License-Identifier: GPL-3.0-or-later
// A walk from triangle to triangle, as over a grid (walk_grid.cpp): a vertex is *near* if its depth
// is less than the plane's, otherwise *far*, and the plane crosses the edges between a near and a
// far vertex. A walk begins at a border edge over which the plane comes in, and ends at another.
// Each walk is a run of vertices; runs are put in order of u.
#include "profiles/cut_mesh.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/facing.hpp"
#include "profiles/profile.hpp"
#include "profiles/surface_edges.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

// The runs of `from`, in order and joined where one ends at the vertex at which the next begins;
// `out` is empty before. A single one is in order, and `from` gets what `out` had.
void put_in_order(Profile& from, std::vector<Run>& runs, Profile& out) {
  if (runs.size() == 1 && runs.front().begin == 0 && runs.front().end == from.size()) {
    std::swap(from.u_m, out.u_m);
    std::swap(from.z_m, out.z_m);
    std::swap(from.after, out.after);
    return;
  }
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

// Crossings on their way into a profile: of edges between vertices that a walk has met. The walk
// itself is a chain in which each step waits for the one before; where edges are crossed is
// reckoned for many at once.
struct CrossedEdges {
  static constexpr std::size_t kMost = 256;

  std::array<double, kMost + 2> u, v, z;     ///< of vertices
  std::array<std::uint16_t, kMost> from, to; ///< the vertex of the lower index first
  std::array<Span, kMost> before;
  std::size_t count = 0;

  void put(std::size_t vertex, ProfilePoint at) {
    u[vertex] = at.u;
    v[vertex] = at.v;
    z[vertex] = at.z;
  }
};

// Exact at both ends. REQUIRES that the plane parts a from b.
ProfilePoint crossing(double depth_m, ProfilePoint a, ProfilePoint b) {
  const double t = (depth_m - a.v) / (b.v - a.v);
  const double u = a.u + t * (b.u - a.u), z = a.z + t * (b.z - a.z);
  return {t >= 1 ? b.u : t <= 0 ? a.u : u, depth_m, t >= 1 ? b.z : t <= 0 ? a.z : z};
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

  MeshWalk(const Mesh& mesh, double depth_m, bool far_at_plane, Profile& out)
      : mesh_(mesh), depth_m_(depth_m), far_at_plane_(far_at_plane), out_(out) {}

  // The run that begins at a side of the border, if there is one; it is appended to `out`.
  std::optional<Run> from(const Side& side) {
    const std::size_t begin = out_.size();
    bool along = false;
    const MeshVertex from = corner(side, 1), to = corner(side, 2);
    if (is_far(from) && !is_far(to)) {
      if constexpr (requires { mesh_.lattice; })
        run_over_lattice(side, from, to);
      else
        run(side, from, to);
    } else if (from.at.v == depth_m_ && to.at.v == depth_m_ &&
               is_far(corner(side, 0)) == is_far(from)) {
      run_along(side, from.at, to.at);
      along = true;
    }
    if (out_.size() <= begin + 1) return std::nullopt;
    return Run{begin, out_.size(), out_.u_m[begin], out_.u_m.back(), along};
  }

private:
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
    const ProfilePoint at = crossing(depth_m_, a, b);
    add(at.u, at.z, before, begin);
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
      side.k = static_cast<std::uint8_t>((side.k + (leaves_beside_near ? 1 : 2)) % 3);
      const auto next = mesh_.across(side);
      if (!next) return;
      side = *next;
    }
  }

  // The same, to the bit. The two triangles at an edge make a parallelogram of the lattice, so the
  // vertex beyond the edge is near + far - (the one behind).
  void run_over_lattice(const Side& side, const MeshVertex& from, const MeshVertex& to) {
    const std::size_t begin = out_.size();
    add_crossing(to, from, Span::gap, begin);
    thread_local CrossedEdges edges;
    edges.count = 0;
    edges.put(0, to.at);
    edges.put(1, from.at);
    struct Met {
      CellVertex place;
      std::uint32_t index;
      std::uint16_t number; ///< in `edges`
    };
    Met near{mesh_.corner(side.triangle, (side.k + 2U) % 3), to.index, 0},
        far{mesh_.corner(side.triangle, (side.k + 1U) % 3), from.index, 1};
    CellVertex next = mesh_.corner(side.triangle, side.k);
    const Grid& grid = mesh_.grid;
    const auto is_there = [&](CellVertex at) {
      return at.column >= 0 && at.row >= 0 && at.column < grid.columns && at.row < grid.rows;
    };
    while (is_there(next)) {
      const auto index = static_cast<std::uint32_t>(grid.index(next.column, next.row));
      const double height = mesh_.heights[index];
      if (std::isnan(height)) break;
      const ProfilePoint at =
          to_profile_frame(mesh_.view, mesh_.lattice.vertex_m(next.column, next.row, height));
      const bool goes_beside_near = far_at_plane_ ? at.v >= depth_m_ : at.v > depth_m_;
      const Met ahead{next, index, static_cast<std::uint16_t>(edges.count + 2)};
      edges.put(ahead.number, at);
      if (!mesh_.level.empty())
        edges.before[edges.count] = span_between(near.place, far.place, next, edges.v[near.number],
                                                 edges.v[far.number], at.v);
      const CellVertex behind = goes_beside_near ? far.place : near.place;
      near = goes_beside_near ? near : ahead;
      far = goes_beside_near ? ahead : far;
      const bool near_first = near.index < far.index;
      edges.from[edges.count] = near_first ? near.number : far.number;
      edges.to[edges.count] = near_first ? far.number : near.number;
      next = {near.place.column + far.place.column - behind.column,
              near.place.row + far.place.row - behind.row};
      if (++edges.count < CrossedEdges::kMost) continue;
      take(edges, begin);
      const auto vertex = [&](std::size_t n) {
        return ProfilePoint{edges.u[n], edges.v[n], edges.z[n]};
      };
      const ProfilePoint near_at = vertex(near.number), far_at = vertex(far.number);
      edges.put(near.number = 0, near_at);
      edges.put(far.number = 1, far_at);
    }
    take(edges, begin);
  }

  // Their crossings, to the run that began at `begin`.
  void take(CrossedEdges& edges, std::size_t begin) {
    std::array<double, CrossedEdges::kMost> u, z;
    for (std::size_t i = 0; i < edges.count; ++i) {
      const std::size_t a = edges.from[i], b = edges.to[i];
      const ProfilePoint at = crossing(depth_m_, {edges.u[a], edges.v[a], edges.z[a]},
                                       {edges.u[b], edges.v[b], edges.z[b]});
      u[i] = at.u;
      z[i] = at.z;
    }
    const bool has_level = !mesh_.level.empty();
    for (std::size_t i = 0; i < edges.count; ++i)
      add(u[i], z[i], has_level ? edges.before[i] : Span::slope, begin);
    edges.count = 0;
  }

  // What the plane meets on its way through a lattice's triangle, as span_of.
  Span span_between(CellVertex near, CellVertex far, CellVertex ahead, double near_v, double far_v,
                    double ahead_v) const {
    const auto span_in = [&](CellVertex a, CellVertex b, CellVertex c) {
      const int column = std::min({a.column, b.column, c.column}),
                row = std::min({a.row, b.row, c.row});
      const auto is_north_east = [&](CellVertex p) { return p.column > column && p.row == row; };
      const bool upper = is_north_east(a) || is_north_east(b) || is_north_east(c);
      return mesh_.span_in(CellHalf{column, row, upper ? Half::upper : Half::lower});
    };
    const Span span = span_in(near, far, ahead);
    const CellVertex on_plane = far_at_plane_ ? far : near, off_plane = far_at_plane_ ? near : far;
    if ((far_at_plane_ ? far_v : near_v) != depth_m_ || ahead_v != depth_m_) return span;
    const CellVertex beyond{on_plane.column + ahead.column - off_plane.column,
                            on_plane.row + ahead.row - off_plane.row};
    const Grid& grid = mesh_.grid;
    if (beyond.column < 0 || beyond.row < 0 || beyond.column >= grid.columns ||
        beyond.row >= grid.rows || std::isnan(grid.height_m(beyond.column, beyond.row)))
      return span;
    return std::max(span, span_in(on_plane, ahead, beyond));
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
  double depth_m_;
  bool far_at_plane_; ///< whether a vertex in the plane counts as far
  Profile& out_;      ///< of one run after the other
};

// The profile of a mesh at a depth.
template <class Mesh>
void cut_mesh(const Mesh& mesh, const BorderSides<typename Mesh::Side>& border, double depth_m,
              bool far_at_plane, Profile& out) {
  thread_local Profile found; // kept for its memory, as runs are
  thread_local std::vector<Run> runs;
  found.clear();
  runs.clear();
  MeshWalk<Mesh> walk(mesh, depth_m, far_at_plane, found);
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

} // namespace

EarthGridCutter::EarthGridCutter(const Grid& grid, const View& view, const TriangleSet& level,
                                 std::span<const BorderEdge> border)
    : grid_(grid), view_(view), level_(level), border_(sides_of(grid, view, border)) {}

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
