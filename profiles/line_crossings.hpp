// SPDX-License-Identifier: GPL-3.0-or-later
// Where a plane crosses a block of lines of a grid's vertices, and the edges between them
// (profiles/line_cutter.cpp).
#pragma once

#include "profiles/profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace orograph {

constexpr int kLines = 128; // in a block, so that all of it stays in the nearest cache
using Numbers = std::array<double, kLines + 1>;

// The edges crossed along a block's lines, from their ends a, of lower index, to b.
struct Block {
  Numbers j, u_a, v_a, z_a, u_b, v_b, z_b;
};

struct Point {
  double u, z;
};

// Where the plane crosses an edge, as walk_grid has it.
inline Point crossing(double depth, double u_a, double v_a, double z_a, double u_b, double v_b,
                      double z_b) {
  const double t = (depth - v_a) / (v_b - v_a);
  const double u = u_a + t * (u_b - u_a), z = z_a + t * (z_b - z_a);
  return {t >= 1 ? u_b : (t <= 0 ? u_a : u), t >= 1 ? z_b : (t <= 0 ? z_a : z)};
}

// The crossings along a block's lines and between them, by turns. Loops without branches, for the
// vector units.
template <bool turned_same, bool turned_more>
void fill_crossings(const Block& l, int count, double depth, double* u, double* z) {
  for (int k = 0; k < count; ++k) {
    const Point p = crossing(depth, l.u_a[k], l.v_a[k], l.z_a[k], l.u_b[k], l.v_b[k], l.z_b[k]);
    u[2 * k] = p.u;
    z[2 * k] = p.z;
  }
  for (int k = 0; k < count; ++k) {
    const bool more = l.j[k + 1] != l.j[k];
    const bool turned = more ? turned_more : turned_same;
    const double u_here = more ? l.u_b[k] : l.u_a[k], u_next = more ? l.u_a[k + 1] : l.u_b[k + 1];
    const double v_here = more ? l.v_b[k] : l.v_a[k], v_next = more ? l.v_a[k + 1] : l.v_b[k + 1];
    const double z_here = more ? l.z_b[k] : l.z_a[k], z_next = more ? l.z_a[k + 1] : l.z_b[k + 1];
    const Point p = crossing(depth, turned ? u_next : u_here, turned ? v_next : v_here,
                             turned ? z_next : z_here, turned ? u_here : u_next,
                             turned ? v_here : v_next, turned ? z_here : z_next);
    u[2 * k + 1] = p.u;
    z[2 * k + 1] = p.z;
  }
}

// Of the vertices from number `begin` on. Around a vertex in the plane all edges cross at that
// vertex: it is there once. Crossings an ulp apart may round to the wrong order. False where a span
// between vertices would have to be asked of other triangles as well.
inline bool drop_repeats(bool special, std::size_t begin, Profile& out) {
  const double *u = out.u_m.data(), *z = out.z_m.data();
  const std::size_t count = out.size();
  std::uint32_t stays = 0; // counted in the way that gets to the vector units
  for (std::size_t m = begin + 1; m < count; ++m)
    if (!(u[m] > u[m - 1])) ++stays;
  if (stays == 0) return true;
  std::size_t kept = begin;
  for (std::size_t m = begin + 1; m < count; ++m) {
    const bool again =
        u[m] == u[kept] && (z[m] == z[kept] || (std::isnan(z[m]) && std::isnan(z[kept])));
    if (again && special) return false;
    kept += again ? 0 : 1;
    out.u_m[kept] = again ? u[kept] : std::max(u[m], u[kept - 1]);
    out.z_m[kept] = z[again ? kept : m];
    if (!again) {
      out.after[kept - 1] = out.after[m - 1];
      out.after[kept] = out.after[m];
    }
  }
  out.resize(kept + 1);
  out.after.back() = Span::gap;
  return true;
}

} // namespace orograph
