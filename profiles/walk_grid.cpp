// SPDX-License-Identifier: GPL-3.0-or-later
// A walk from triangle to triangle. A vertex is *near* if its depth is less than the plane's,
// otherwise *far*; the plane crosses the edges between a near and a far vertex. Walking to the
// right, `near` is on the right hand and `far` on the left. The two triangles at any edge of the
// grid make a parallelogram, so the vertex beyond the edge is near + far - (the vertex behind).
#include "profiles/walk_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace orograph {
namespace {

struct Vertex {
  int column, row;
  double u, v, z;
};

template <class Height>
struct Walk {
  const Grid& grid;
  const PlaneLattice& lattice;
  const Heights<Height>& heights;
  const View& view;
  const TriangleSet& level;
  double depth;
  bool far_at_plane; ///< whether a vertex in the plane counts as far
  Profile& out;

  bool inside(int column, int row) const {
    return column >= 0 && row >= 0 && column < grid.columns && row < grid.rows;
  }
  Vertex vertex(int column, int row) const {
    const double height = heights[grid.index(column, row)];
    const ProfilePoint p = to_profile_frame(view, lattice.vertex_m(column, row, height));
    return {column, row, p.u, p.v, p.z};
  }
  bool is_far(const Vertex& p) const { return far_at_plane ? p.v >= depth : p.v > depth; }

  // The crossing of the plane with edge near-far, appended unless it is the last vertex again.
  void add_crossing(const Vertex& near, const Vertex& far, Span before) {
    const bool near_first = grid.index(near.column, near.row) < grid.index(far.column, far.row);
    const Vertex& a = near_first ? near : far;
    const Vertex& b = near_first ? far : near;
    const double t = (depth - a.v) / (b.v - a.v);
    double u = a.u + t * (b.u - a.u), z = a.z + t * (b.z - a.z);
    if (t >= 1) u = b.u, z = b.z;
    if (t <= 0) u = a.u, z = a.z;
    if (out.size() > 0) {
      // Around a vertex in the plane all edges cross at that vertex: it is there once, and the
      // triangles that only touch it don't matter.
      if (u == out.u_m.back() &&
          (z == out.z_m.back() || (std::isnan(z) && std::isnan(out.z_m.back()))))
        return;
      out.after.back() = before;
      u = std::max(u, out.u_m.back()); // crossings an ulp apart may round to the wrong order
    }
    out.u_m.push_back(u);
    out.z_m.push_back(z);
    out.after.push_back(Span::gap);
  }

  // What triangle (a, b, c) holds of the surface.
  Span span_in(const Vertex& a, const Vertex& b, const Vertex& c) const {
    if (std::isnan(a.z) || std::isnan(b.z) || std::isnan(c.z)) return Span::gap;
    if (level.empty()) return Span::slope;
    const int column = std::min({a.column, b.column, c.column});
    const int row = std::min({a.row, b.row, c.row});
    const auto is_north_east = [&](const Vertex& p) { return p.column > column && p.row == row; };
    const bool upper = is_north_east(a) || is_north_east(b) || is_north_east(c);
    return level.has(grid_triangle(grid, column, row, upper ? Half::upper : Half::lower))
               ? Span::level
               : Span::slope;
  }

  // What the plane meets on its way through triangle (near, far, ahead).
  Span span_of(const Vertex& near, const Vertex& far, const Vertex& ahead) const {
    const Span span = span_in(near, far, ahead);
    // An edge in the plane belongs to the triangle on its other side as well.
    const Vertex& on_plane = far_at_plane ? far : near;
    const Vertex& off_plane = far_at_plane ? near : far;
    if (on_plane.v != depth || ahead.v != depth) return span;
    const int column = on_plane.column + ahead.column - off_plane.column;
    const int row = on_plane.row + ahead.row - off_plane.row;
    return inside(column, row) ? std::max(span, span_in(on_plane, ahead, vertex(column, row)))
                               : span;
  }

  // From the border edge near-far inwards, where `ahead` is the vertex of the border triangle.
  void run(Vertex near, Vertex far, int ahead_column, int ahead_row) {
    add_crossing(near, far, Span::gap);
    while (inside(ahead_column, ahead_row)) {
      const Vertex ahead = vertex(ahead_column, ahead_row);
      const Span span = span_of(near, far, ahead);
      Vertex behind;
      if (is_far(ahead)) {
        behind = far;
        far = ahead;
      } else {
        behind = near;
        near = ahead;
      }
      add_crossing(near, far, span);
      ahead_column = near.column + far.column - behind.column;
      ahead_row = near.row + far.row - behind.row;
    }
  }
};

// One side of the grid, walked counterclockwise as seen from above: from vertex `first` on in
// steps, with the inner vertex of the border triangle at edge i given by `inner` + i steps.
struct Side {
  int column, row, column_step, row_step, edges, inner_column, inner_row;
};

std::array<Side, 4> sides_of(const Grid& grid) {
  const int c = grid.columns - 1, r = grid.rows - 1;
  return {{{0, 0, 0, 1, r, 1, 1},          // west, southward
           {0, r, 1, 0, c, 0, r - 1},      // south, eastward
           {c, r, 0, -1, r, c - 1, r - 1}, // east, northward
           {c, 0, -1, 0, c, c, 1}}};       // north, westward
}

struct Entry {
  int near_column, near_row, far_column, far_row, ahead_column, ahead_row;
  double u;
};

// Walks from every border edge that goes from far to near: there the plane comes in. There is one
// such edge unless a side is so nearly parallel to the plane that rounding decides.
template <class Height>
void walk_all(Walk<Height>& walk, bool monotone) {
  std::vector<Entry> entries;
  for (const Side& side : sides_of(walk.grid)) {
    const auto at = [&](int i) {
      return walk.vertex(side.column + i * side.column_step, side.row + i * side.row_step);
    };
    const auto enter = [&](int i) {
      const Vertex far = at(i), near = at(i + 1);
      entries.push_back({near.column, near.row, far.column, far.row,
                         side.inner_column + i * side.column_step,
                         side.inner_row + i * side.row_step, std::min(near.u, far.u)});
    };
    if (!monotone) {
      for (int i = 0; i < side.edges; ++i)
        if (walk.is_far(at(i)) && !walk.is_far(at(i + 1))) enter(i);
    } else if (walk.is_far(at(0)) && !walk.is_far(at(side.edges))) {
      int far = 0, near = side.edges;
      while (near - far > 1) {
        const int middle = (far + near) / 2;
        (walk.is_far(at(middle)) ? far : near) = middle;
      }
      enter(far);
    }
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.u < b.u; });
  for (const Entry& e : entries)
    walk.run(walk.vertex(e.near_column, e.near_row), walk.vertex(e.far_column, e.far_row),
             e.ahead_column, e.ahead_row);
}

} // namespace

void walk_grid(const Grid& grid, const View& view, const TriangleSet& level, const GridPlane& plane,
               bool monotone, Profile& out) {
  std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        Walk<Height> walk{grid,          grid.plane(),       heights, view, level,
                          plane.depth_m, plane.far_at_plane, out};
        walk_all(walk, monotone);
      },
      grid.heights_m);
}

} // namespace orograph
