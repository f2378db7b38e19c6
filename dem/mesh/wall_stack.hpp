// SPDX-License-Identifier: GPL-3.0-or-later
// Walls over one line, and the places where they are cut.
#pragma once

#include "dem/mesh/piece_vertices.hpp"
#include "dem/tin.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace orograph {

/// Ground beside a wall.
struct BesideWall {
  std::uint32_t triangle = 0;
  PlanEdge edge;          ///< that it shares with the wall
  std::uint32_t apex = 0; ///< its vertex off the edge
};

struct WallStack {
  std::vector<std::uint32_t> walls;
  std::vector<PlanEdge> edges; ///< of the walls, those that aren't upright; in order, each once
  std::vector<BesideWall> grounds;

  /// Places along the line seen from above, by the coordinate that grows faster along it.
  struct Column {
    double along;
    Vec2 place;
  };
  std::map<double, Vec2> columns;
  std::vector<double> new_columns; ///< those over none of the vertices
  bool along_x = true;

  double along(const Tin& tin, std::uint32_t vertex) const {
    return along_x ? tin.vertices_m[vertex].x : tin.vertices_m[vertex].y;
  }
  /// A column at a share of an edge, or the nearest within rounding that is there. Never the edge's
  /// own ends. REQUIRES a place that isn't within rounding of them.
  double add_column(const Tin& tin, const PlanEdge& edge, double share);
  /// Moves new columns that have ground on one side of the line only to that side, by rounding.
  void round_to_ground(const Tin& tin);
  /// Columns strictly between two, whichever is the greater.
  std::vector<Column> between(double one, double other) const;
};

/// The walls that can be reached over edges that aren't upright.
WallStack stack_of(const Tin& tin, std::uint32_t wall);

} // namespace orograph
