// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulations of the plane that have given lines among their edges.
#pragma once

#include "geometry/vec.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace orograph {

/// Triangles as a Tin has them, and over their convex hull all of them.
struct PlaneMesh {
  std::vector<std::array<std::uint32_t, 3>> triangles, neighbours;
};

/// A place as a mean of vertices: right to the last bit, however thin their triangle.
struct Share {
  std::uint32_t vertex;
  double share;
};

/// Vertices are numbered as they come. Lines are straight, from a vertex to another; where two
/// cross, or one runs through a vertex, they are split there. A crossing's place is rounded to
/// double, which bends lines by that much; all decisions are exact all the same, so every triangle
/// has an area and none overlap.
/// The triangulation depends on the places, and on the lines and their order, only.
class PlaneTriangulation {
public:
  /// REQUIRES places that are all different; fast where near ones are near in order.
  explicit PlaneTriangulation(std::span<const Vec2> places);
  ~PlaneTriangulation();
  PlaneTriangulation(const PlaneTriangulation&) = delete;
  PlaneTriangulation& operator=(const PlaneTriangulation&) = delete;

  /// False while all vertices are on one line. Everything below but `insert` REQUIRES true.
  bool has_area() const;
  const std::vector<Vec2>& places() const;

  /// The vertex at a place, made if need be.
  std::uint32_t insert(Vec2 place);
  /// Lines are numbered from 0. REQUIRES from != to. Throws Error where lines are so close to each
  /// other that double precision can't tell them apart.
  std::uint32_t add_line(std::uint32_t from, std::uint32_t to);
  /// Vertices of a line in order, those where it was split by now included; neighbouring ones are
  /// joined by an edge.
  std::vector<std::uint32_t> line(std::uint32_t number) const;

  /// The one vertex at a place, the two of the edge or the three of the triangle that it is on,
  /// with shares that sum to 1; none outside of the hull.
  std::vector<Share> around(Vec2 place) const;
  /// Triangles that a segment meets, their borders included. REQUIRES both ends in the hull.
  std::vector<std::array<std::uint32_t, 3>> triangles_along(Vec2 from, Vec2 to) const;
  std::vector<std::array<std::uint32_t, 2>> hull_edges() const;
  PlaneMesh mesh() const;

private:
  std::vector<std::uint32_t> vertices_along(std::uint32_t from, std::uint32_t to) const;

  struct Inside;
  std::unique_ptr<Inside> inside_;
};

using Edge = std::array<std::uint32_t, 2>; ///< two vertices

/// Whatever the direction: equal for an edge and its reverse.
inline std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return a < b ? std::uint64_t{a} << 32U | b : std::uint64_t{b} << 32U | a;
}

/// The steps of a polyline that go anywhere.
void append_edges(std::span<const std::uint32_t> polyline, bool closed, std::vector<Edge>& edges);

/// Adds each edge once, in an order that doesn't depend on the given one; the line of each.
std::vector<std::uint32_t> add_lines(PlaneTriangulation& plane, std::span<const Edge> edges);

struct SplitHeights {
  std::uint64_t vertices = 0; ///< that got a height
  double greatest_m = 0;      ///< how far apart the lines were at one of them
};

/// A vertex without height (NaN) that splits lines gets the mean of those lines' own heights there.
/// A line's height goes evenly from its first vertex to its last. `heights_m` grows to the number
/// of places.
SplitHeights add_heights_of_lines(const PlaneTriangulation& plane,
                                  std::span<const std::uint32_t> lines,
                                  std::vector<double>& heights_m);

/// The same, where a line's height goes evenly between those of its vertices that have one; beyond
/// them it has none.
SplitHeights add_heights_between(const PlaneTriangulation& plane,
                                 std::span<const std::uint32_t> lines,
                                 std::vector<double>& heights_m);

/// Puts rings that have no heights, by their places, into the triangulation so that each of their
/// edges runs along its edges, and the surface stays as it is: triangles that a ring meets are only
/// split. Vertices beyond the hull of what was there have no height (NaN) afterwards; all others
/// have one. `heights_m` holds one for each vertex and grows with them. Returns the rings' lines.
std::vector<std::uint32_t> cut_by_rings(PlaneTriangulation& plane,
                                        const std::vector<std::vector<Vec2>>& rings,
                                        const std::vector<std::uint32_t>& breaklines,
                                        std::vector<double>& heights_m);

/// A flag for each triangle of `plane.mesh()`. `ring_lines` are the lines of closed rings, a line
/// as often as rings run along it.
std::vector<char> inside_rings(const PlaneTriangulation& plane, const PlaneMesh& mesh,
                               std::span<const std::uint32_t> ring_lines);

/// A triangulation with some straight lines as edges.
struct TriangulatedLines {
  /// Counterclockwise, exactly; no two overlap. They fill the points' convex hull.
  std::vector<std::array<std::uint32_t, 3>> faces;
  /// For each given line the points that it goes through, from its first to its last.
  std::vector<std::vector<std::uint32_t>> through;
};

/// The constrained Delaunay triangulation of points, taken in their order, and of lines between
/// them. REQUIRES points that are all different, and lines of which none crosses another.
TriangulatedLines triangulate_lines(std::span<const Vec2> points, std::span<const Edge> lines);

} // namespace orograph
