// SPDX-License-Identifier: GPL-3.0-or-later
// From surveyed points and lines to a Tin.
#pragma once

#include "dem/tin.hpp"
#include "dem/triangulate/triangulation_counts.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace orograph {

/// A closed line; its last point is joined to the first.
struct BoundaryRing {
  std::vector<Vec3> points_m; ///< z is NaN in all of them where the ring has no heights
};

/// What was surveyed, ground frame, metres.
struct Survey {
  std::vector<Vec3> points_m;
  std::vector<std::vector<Vec3>> breaklines_m; ///< edges of the surface, each a polyline
  /// Outer boundaries and holes, told apart by nesting: ground inside an odd number of rings is
  /// kept. None keeps all. A ring with heights is a breakline as well. One without cuts the surface
  /// as scissors do: it takes its heights from it, and where it runs beyond the points nothing is
  /// added.
  std::vector<BoundaryRing> boundary;
  /// Triangles with a longer edge (seen from above) are taken away, from the border inwards.
  std::optional<double> max_edge_m;
};

struct Triangulated {
  Tin tin; ///< valid; vertices and triangles in an order in which near ones are near in memory
  TriangulationCounts counts;
};

/// The constrained Delaunay triangulation of all points, with every stretch of a breakline an edge.
///  (1) Points at one place (equal x and y) become one vertex: a breakline's height is preferred to
///      a point's; among several of a kind it is their mean.
///  (2) Where lines cross between their vertices there is a vertex; its height is the mean of the
///      lines' own there. A vertex that lies on another line keeps its height.
///  (3) The same input gives the same Tin, whatever the machine.
/// Throws Error where no triangle comes out: fewer than three places, all on one line, nothing left
/// inside the boundary or below `max_edge_m`.
/// Cost O(n log n); a million points take a few seconds.
Triangulated triangulate(const Survey& survey);

} // namespace orograph
