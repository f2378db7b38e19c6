// SPDX-License-Identifier: GPL-3.0-or-later
// A surface's triangles seen from above, to walk over from neighbour to neighbour, with a value at
// each vertex.
#pragma once

#include "dem/surface.hpp"
#include "dem/tin.hpp"
#include "geometry/vec.hpp"
#include "profiles/isolines.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace orograph {

class PlanTriangles {
public:
  /// REQUIRES that both outlive it.
  PlanTriangles(const Surface& surface, const VertexValues& values);

  /// Vertex numbers; those of a grid's triangle are there whether it is or not.
  std::array<std::uint32_t, 3> corners(std::uint32_t triangle) const;
  /// Beyond the side opposite to corner k; kNoTriangle where the surface ends.
  std::uint32_t across(std::uint32_t triangle, std::size_t k) const;
  /// Metres on the ground; of a grid in degrees those of its middle.
  Vec2 place_m(std::uint32_t vertex) const;
  /// NaN where there is no vertex.
  double value(std::uint32_t vertex) const;

private:
  const Grid* grid_ = nullptr;
  const Tin* tin_ = nullptr;
  Vec2 column_m_, row_m_;
  const VertexValues& values_;
};

/// A straight piece within a triangle; shares of its corners at both ends.
struct DownhillPiece {
  std::array<double, 3> from, to;
  std::uint32_t triangle;
};

/// The way straight down the slope of a triangle from a place in it, and on in the same direction
/// as long as the value falls: at most `most_m` far, and down to `lowest`. Empty where the triangle
/// is level, or a wall.
std::vector<DownhillPiece> downhill(const PlanTriangles& triangles, std::uint32_t triangle,
                                    Vec2 place_m, double most_m, double lowest);

} // namespace orograph
