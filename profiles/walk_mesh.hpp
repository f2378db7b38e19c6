// SPDX-License-Identifier: GPL-3.0-or-later
// A walk from triangle to triangle, as over a grid (cut_grid.cpp): a vertex is *near* if its depth
// is less than the plane's, otherwise *far*, and the plane crosses the edges between a near and a
// far vertex. A walk begins at a border edge over which the plane comes in, and ends at another.
// Each walk is a run of vertices; runs are put in order of u.
#pragma once

#include "profiles/border_sides.hpp"
#include "profiles/mesh_vertex.hpp"
#include "profiles/profile_runs.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace orograph {

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

  MeshWalk(const Mesh& mesh, double depth_m, bool far_at_plane, Profile& out)
      : mesh_(mesh), depth_m_(depth_m), far_at_plane_(far_at_plane), out_(out) {}

  /// The run that begins at a side of the border, if there is one; it is appended to `out`.
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
  double depth_m_;
  bool far_at_plane_; ///< whether a vertex in the plane counts as far
  Profile& out_;      ///< of one run after the other
};

/// The profile of a mesh at a depth.
template <class Mesh>
void cut_mesh(const Mesh& mesh, const BorderSides<typename Mesh::Side>& border, double depth_m,
              bool far_at_plane, Profile& out) {
  Profile found;
  std::vector<Run> runs;
  MeshWalk<Mesh> walk(mesh, depth_m, far_at_plane, found);
  for (const auto& side : border.at(depth_m))
    if (const auto run = walk.from(side)) runs.push_back(*run);
  keep_ground_in_front(runs);
  put_in_order(found, runs, out);
}

} // namespace orograph
