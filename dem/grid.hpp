// SPDX-License-Identifier: GPL-3.0-or-later
// A grid of heights: the terrain of a DEM (docs/how-it-works.md).
#pragma once

#include "dem/frame/earth_lattice.hpp"
#include "dem/heights.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <variant>
#include <vector>

namespace orograph {

/// Vertices at equal steps on a map plane, in metres east and north in the ground frame, whose
/// origin is near the terrain, so that they are small numbers.
struct PlaneLattice {
  Vec2 first_vertex_m; ///< ground position of vertex (0, 0), the north-west one
  Vec2 column_step_m;  ///< from a column to the next, eastward
  Vec2 row_step_m;     ///< from a row to the next, southward

  Vec2 position_m(int column, int row) const {
    return {first_vertex_m.x + column * column_step_m.x + row * row_step_m.x,
            first_vertex_m.y + column * column_step_m.y + row * row_step_m.y};
  }
  Vec3 vertex_m(int column, int row, double height_m) const {
    const Vec2 at = position_m(column, row);
    return {at.x, at.y, height_m};
  }
  /// Whether rows run to the left of columns, seen from above; no reader makes such a grid.
  bool is_mirrored() const { return cross(column_step_m, row_step_m) > 0; }
};

/// Vertices in rows from the north, columns from the west, with heights in metres; NaN where there
/// is none. Each cell of four vertices is split by the diagonal from (column, row) to
/// (column + 1, row + 1) into an upper triangle (with the vertex to the north-east) and a lower one
/// (with the vertex to the south-west). A triangle with a NaN vertex isn't there.
///
/// A DEM in metres lies on its map plane; one in degrees on the ellipsoid, where a vertex leans
/// with its height.
struct Grid {
  int columns = 0, rows = 0;
  std::variant<PlaneLattice, EarthLattice> lattice;
  /// Row-major, rows * columns; shared by copies. float unless the file has heights in double
  /// precision.
  std::variant<Heights<float>, Heights<double>> heights_m;

  bool is_on_earth() const { return std::holds_alternative<EarthLattice>(lattice); }
  const EarthLattice& earth() const { return std::get<EarthLattice>(lattice); }
  PlaneLattice& plane() { return std::get<PlaneLattice>(lattice); }
  const PlaneLattice& plane() const { return std::get<PlaneLattice>(lattice); }

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  std::size_t size() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  }
  /// Height of one vertex; for loops over many, `std::visit` the heights once instead.
  double height_m(int column, int row) const {
    return std::visit([&](const auto& h) { return static_cast<double>(h[index(column, row)]); },
                      heights_m);
  }
  /// Its place in the ground frame. Everything that needs one vertex asks here or the lattice
  /// itself, so that it is the same number everywhere. NaN where there is no height (on a map plane
  /// in z alone).
  Vec3 vertex_m(int column, int row) const {
    return std::visit([&](const auto& l) { return l.vertex_m(column, row, height_m(column, row)); },
                      lattice);
  }
  Vec3 vertex_m(std::size_t index) const {
    const auto across = static_cast<std::size_t>(columns);
    return vertex_m(static_cast<int>(index % across), static_cast<int>(index / across));
  }
};

} // namespace orograph
