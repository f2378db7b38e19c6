// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on a surface along which a value has one of some levels: contours, where the value is the
// height; lines along the shore, a mesh, a graticule, where it is a distance or a coordinate.
#pragma once

#include "dem/surface.hpp"
#include "profiles/seen_ground.hpp"
#include "profiles/slab_lines.hpp"
#include "profiles/triangles.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace orograph {

/// A straight line within a triangle. Its ends are numbers of vertices, and from the surface's
/// count of them on of points; from < to.
struct Isoline {
  std::uint32_t from, to;
  std::uint32_t triangle; ///< number in its surface; of a grid as `grid_triangle` has it
  std::uint32_t level;    ///< number

  SurfaceEdge ends() const { return {from, to}; }
};

struct Isolines {
  std::vector<EdgePoint> points; ///< within edges; what is at a vertex is that vertex
  std::vector<Isoline> lines;
};

/// Gives the values of `out.size()` vertices from number `first` on; NaN where there is none.
/// Called from several threads.
using VertexValues = std::function<void(std::size_t first, std::span<double> out)>;

/// Which part of a surface is asked for.
struct IsolineGround {
  const SeenGround* seen = nullptr;       ///< of a grid: only cells that are looked at
  const TriangleSet* triangles = nullptr; ///< only these
};

/// Where a value that is linear on each triangle has one of `levels`, which rise. A vertex whose
/// value is a level counts as above it: then every triangle is crossed by two of its edges or by
/// none, and no case is left over. Pieces without length are none, and one along an edge that both
/// its triangles have is there once. Lines of one level meet in one and the same point, and each
/// but those along such an edge goes on, or ends at the border of what is asked for.
/// Cost: 3 ns a vertex of a grid that no line comes near, and 30 ns a line.
Isolines isolines(const Surface& surface, const VertexValues& values,
                  std::span<const double> levels, const IsolineGround& ground = {});

} // namespace orograph
