// SPDX-License-Identifier: GPL-3.0-or-later
// A constrained Delaunay triangulation of the plane that grows; the only place that knows CGAL's.
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

} // namespace orograph
