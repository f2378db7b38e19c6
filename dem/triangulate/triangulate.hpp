// SPDX-License-Identifier: GPL-3.0-or-later
// From surveyed points and lines to a Tin.
#pragma once

#include "dem/tin.hpp"

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

struct TriangulationCounts {
  std::uint64_t points = 0;     ///< given, the vertices of lines included
  std::uint64_t merged = 0;     ///< points that lay where another one was
  double greatest_merged_m = 0; ///< how far apart in height they were at one place, at most
  std::uint64_t breaklines = 0;
  std::uint64_t crossings = 0;       ///< places where lines cross between their vertices
  double greatest_crossing_m = 0;    ///< how far apart in height the lines are there, at most
  std::uint64_t beyond_max_edge = 0; ///< triangles taken away
  std::uint64_t outside = 0;         ///< triangles outside the boundary
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
