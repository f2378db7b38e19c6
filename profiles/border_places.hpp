// SPDX-License-Identifier: GPL-3.0-or-later
// Where the border of a grid on the ellipsoid is, so that of its many sides each of many cutters
// looks at those few that matter to it.
#pragma once

#include "dem/grid.hpp"
#include "geometry/box.hpp"
#include "profiles/cut_mesh.hpp"
#include "profiles/mesh.hpp"
#include "profiles/outline.hpp"
#include "profiles/profile.hpp"
#include "view/view.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace orograph {

/// A border's sides and their places on the ground, in tiles of the lattice. The same for all views
/// of a grid. Memory: 72 bytes a side.
struct BorderPlaces {
  struct PlacedSide {
    GridSide side;
    std::uint32_t number; ///< in the border
    Vec3 from_m, to_m;    ///< its corners k + 1 and k + 2
  };
  /// Of cells; the last ones included.
  struct Tile {
    int first_column, last_column, first_row, last_row;
    Box2 box_m;               ///< of its sides' ends
    std::uint32_t begin, end; ///< in `sides`
  };
  std::vector<PlacedSide> sides; ///< tile after tile, each in the border's order
  std::vector<Tile> tiles;       ///< that have any
};

/// REQUIRES a grid on the ellipsoid, and its border as `border_edges` has it. Cost: 0.1 us a side.
BorderPlaces border_places(const Grid& grid, std::span<const BorderEdge> border);

/// The same for one view. Cost: a look at each tile, and at the sides of a few.
class BorderInView {
public:
  BorderInView(std::shared_ptr<const BorderPlaces> places, const View& view);

  /// Of all sides; of no side at all, infinity and -infinity.
  double nearest_m() const { return nearest_m_; }
  double farthest_m() const { return farthest_m_; }

  /// Cells, the last ones included; none where first is greater than last.
  struct Cells {
    int first_column, last_column, first_row, last_row;

    bool empty() const { return first_column > last_column || first_row > last_row; }
    bool has(const CellHalf& t) const {
      return t.column >= first_column && t.column <= last_column && t.row >= first_row &&
             t.row <= last_row;
    }
  };
  /// The sides that the plane at a depth meets, in the border's order, of those that reach into a
  /// part of the profile or are of triangles in some cells.
  void at(double depth_m, const URange& part, const Cells& cells, std::vector<GridSide>& out) const;

private:
  std::shared_ptr<const BorderPlaces> places_;
  View view_;
  double nearest_m_, farthest_m_;
  BorderSides<std::uint32_t> tiles_; ///< by depth
};

} // namespace orograph
