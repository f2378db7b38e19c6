// SPDX-License-Identifier: GPL-3.0-or-later
// A walk from triangle to triangle, as over a grid (walk_grid.cpp): a vertex is *near* if its depth
// is less than the plane's, otherwise *far*, and the plane crosses the edges between a near and a
// far vertex. A walk begins at a border edge over which the plane comes in, and ends at another.
// Each walk is a run of vertices; runs are put in order of u. Where a part of a profile is asked
// for, walks begin as well at the sides of a few cells about its left end, and end beyond its right
// one.
#pragma once

#include "profiles/mesh.hpp"
#include "profiles/profile.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace orograph {

/// One walk's vertices, [begin, end) of those found.
struct Run {
  std::size_t begin, end;
  double u_first, u_last;
  bool along; ///< a border edge in the plane, with nothing in front of it
};

/// Takes away border edges in the plane that lie where there is ground in front of it as well: a
/// wall is missing between the two.
void keep_ground_in_front(std::vector<Run>& runs);

/// The runs of `from`, in order and joined where one ends at the vertex at which the next begins;
/// REQUIRES an empty `out`. A single one is in order, and `from` gets what `out` had.
void put_in_order(Profile& from, std::vector<Run>& runs, Profile& out);

/// Crossings on their way into a profile: of edges between vertices that a walk has met. The walk
/// itself is a chain in which each step waits for the one before; where edges are crossed is
/// reckoned for many at once.
struct CrossedEdges {
  static constexpr std::size_t kMost = 256;

  std::array<double, kMost + 2> u, v, z;     ///< of vertices
  std::array<std::uint16_t, kMost> from, to; ///< the vertex of the lower index first
  std::array<Span, kMost> before;
  std::array<std::uint32_t, kMost> triangles; ///< before
  std::size_t count = 0;

  void put(std::size_t vertex, ProfilePoint at) {
    u[vertex] = at.u;
    v[vertex] = at.v;
    z[vertex] = at.z;
  }
};

/// Exact at both ends. REQUIRES that the plane parts a from b.
inline ProfilePoint crossing(double depth_m, ProfilePoint a, ProfilePoint b) {
  const double t = (depth_m - a.v) / (b.v - a.v);
  const double u = a.u + t * (b.u - a.u), z = a.z + t * (b.z - a.z);
  return {t >= 1 ? b.u : t <= 0 ? a.u : u, depth_m, t >= 1 ? b.z : t <= 0 ? a.z : z};
}

/// A Mesh has triangles whose corners run counterclockwise seen from above, and
///   Side               {triangle, k}: the side of a triangle opposite to its corner k
///   vertex(t, k)       a triangle's corner, a MeshVertex
///   across(side)       the same side of the triangle beyond it; none at the border
///   span_in(t)         what the triangle holds of the surface
///   is_wall(t)
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
    if (is_far(from) && !is_far(to)) {
      go_in(side, from, to);
    } else if (from.at.v == depth_m_ && to.at.v == depth_m_ &&
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
    if (is_far(from) && !is_far(to)) go_in(side, from, to);
    return found_from(begin, false);
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

  static constexpr bool kTellsTriangles = requires(Mesh mesh) { mesh.lattice; };

  void add(double u, double z, Span before, std::size_t begin,
           [[maybe_unused]] std::uint32_t triangle = kNoTriangle) {
    if (out_.size() > begin) {
      // Around a vertex in the plane all edges cross at that vertex: it is there once, and the
      // triangles that only touch it don't matter.
      if (u == out_.u_m.back() && z == out_.z_m.back()) return;
      out_.after.back() = before;
      if constexpr (kTellsTriangles) out_.triangles.back() = triangle;
      // Crossings an ulp apart may round to the wrong order, and a wall's differ by as much.
      u = before == Span::wall ? out_.u_m.back() : std::max(u, out_.u_m.back());
    }
    out_.u_m.push_back(u);
    out_.z_m.push_back(z);
    out_.after.push_back(Span::gap);
    if constexpr (kTellsTriangles) out_.triangles.push_back(kNoTriangle);
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

  // From a side of the border inwards, or from any.
  void go_in(const Side& side, const MeshVertex& far, const MeshVertex& near) {
    if constexpr (kTellsTriangles)
      run_over_lattice(side, far, near);
    else
      run(side, far, near);
  }

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
      edges.triangles[edges.count] = triangle_of(near.place, far.place, next);
      const CellVertex behind = goes_beside_near ? far.place : near.place;
      near = goes_beside_near ? near : ahead;
      far = goes_beside_near ? ahead : far;
      const bool near_first = near.index < far.index;
      edges.from[edges.count] = near_first ? near.number : far.number;
      edges.to[edges.count] = near_first ? far.number : near.number;
      next = {near.place.column + far.place.column - behind.column,
              near.place.row + far.place.row - behind.row};
      ++edges.count;
      if (edges.u[near.number] > high_m_ && edges.u[far.number] > high_m_) break;
      // Round a spike that leans beyond upright: without end, if nothing stopped it.
      if (near.index == to.index && far.index == from.index) break;
      if (edges.count < CrossedEdges::kMost) continue;
      if (!take(edges, begin)) return;
      const auto vertex = [&](std::size_t n) {
        return ProfilePoint{edges.u[n], edges.v[n], edges.z[n]};
      };
      const ProfilePoint near_at = vertex(near.number), far_at = vertex(far.number);
      edges.put(near.number = 0, near_at);
      edges.put(far.number = 1, far_at);
    }
    take(edges, begin);
  }

  // Their crossings, to the run that began at `begin`; whether it goes on.
  bool take(CrossedEdges& edges, std::size_t begin) {
    std::array<double, CrossedEdges::kMost> u, z;
    for (std::size_t i = 0; i < edges.count; ++i) {
      const std::size_t a = edges.from[i], b = edges.to[i];
      const ProfilePoint at = crossing(depth_m_, {edges.u[a], edges.v[a], edges.z[a]},
                                       {edges.u[b], edges.v[b], edges.z[b]});
      u[i] = at.u;
      z[i] = at.z;
    }
    const bool has_level = !mesh_.level.empty();
    for (std::size_t i = 0; i < edges.count; ++i) {
      add(u[i], z[i], has_level ? edges.before[i] : Span::slope, begin, edges.triangles[i]);
      if (out_.u_m.back() > high_m_) return false;
    }
    edges.count = 0;
    return true;
  }

  // Of the upper triangle's corners two are in the east, of the lower one's one is.
  std::uint32_t triangle_of(CellVertex a, CellVertex b, CellVertex c) const {
    const int column = std::min({a.column, b.column, c.column}),
              row = std::min({a.row, b.row, c.row}),
              in_the_east = a.column + b.column + c.column - 3 * column;
    return 2 * (static_cast<std::uint32_t>(row) *
                    (static_cast<std::uint32_t>(mesh_.grid.columns) - 1) +
                static_cast<std::uint32_t>(column)) +
           static_cast<std::uint32_t>(in_the_east - 1);
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
    std::uint32_t triangle = kNoTriangle;
    if constexpr (kTellsTriangles)
      triangle = triangle_of(mesh_.corner(side.triangle, 0), mesh_.corner(side.triangle, 1),
                             mesh_.corner(side.triangle, 2));
    add(right.u, right.z, mesh_.is_wall(side.triangle) ? Span::slope : mesh_.span_in(side.triangle),
        begin, triangle);
  }

  const Mesh& mesh_;
  double depth_m_, high_m_;
  bool far_at_plane_; ///< whether a vertex in the plane counts as far
  Profile& out_;      ///< of one run after the other
};

/// The profile of a mesh at a depth. `border`: at least those of its sides that the plane meets.
template <class Mesh>
void cut_mesh(const Mesh& mesh, std::span<const typename Mesh::Side> border, double depth_m,
              bool far_at_plane, Profile& out) {
  thread_local Profile found; // kept for its memory, as runs are
  thread_local std::vector<Run> runs;
  found.clear();
  runs.clear();
  MeshWalk<Mesh> walk(mesh, depth_m, URange{}.high_m, far_at_plane, found);
  for (const auto& side : border)
    if (const auto run = walk.from(side)) runs.push_back(*run);
  keep_ground_in_front(runs);
  put_in_order(found, runs, out);
}

} // namespace orograph
