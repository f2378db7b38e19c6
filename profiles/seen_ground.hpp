// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of a grid are looked at, in blocks of cells: not ground beside the page, nor ground
// wholly under the horizon of what stands in front of it.
#pragma once

#include "dem/grid.hpp"
#include "geometry/box.hpp"
#include "geometry/segment.hpp"
#include "profiles/border_places.hpp"
#include "profiles/profile.hpp"
#include "view/view.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace orograph {

/// Blocks of `kSide` by `kSide` cells, fewer at the grid's end; each is looked at or not.
struct SeenGround {
  static constexpr int kSide = 8;
  int columns = 0, rows = 0;      ///< of blocks
  std::vector<std::uint8_t> seen; ///< row-major; 0 or 1

  explicit SeenGround(const Grid& grid);
  /// Along so many cells.
  static int blocks_in(int cells) { return (cells + kSide - 1) / kSide; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  /// Share of blocks that are looked at.
  double share() const;
  /// Those that the other looks at as well. REQUIRES one of the same grid.
  void add(const SeenGround& other);
  /// Columns of cells that are looked at in a row of blocks: from `first` to `second`, rising and
  /// apart.
  void cells_in_row(int block_row, int cell_columns, std::vector<std::pair<int, int>>& out) const;
};

/// Where the planes of constant depth pass a grid's blocks. REQUIRES a grid on a map plane.
class PlaneOverBlocks {
public:
  PlaneOverBlocks(const Grid& grid, const View& view);

  /// The parts of the profile at a depth that are within `within` and in seen blocks: rising, at
  /// least two blocks apart. Between them there may be parts that aren't in seen blocks.
  void seen_parts(double depth_m, const URange& within, const SeenGround& ground,
                  std::vector<URange>& out) const;

private:
  int cells_along_,
      cells_across_;         ///< in the grid, along the axis that the planes follow, and across
  bool along_columns_;       ///< that axis: from column to column
  double first_u_, first_v_; ///< of the grid's first vertex
  double u_along_, v_along_, u_across_, v_across_; ///< in a cell
};

/// What holds the ground of each block, or group of blocks, its border's vertices too; row by row.
struct BoundsOfBlocks {
  int columns = 0;
  std::vector<double> heights; ///< on a map plane: the greatest; -infinity where there is none
  std::vector<Box3> boxes_m;   ///< on the ellipsoid: of all vertices; empty where there are none

  std::size_t count() const { return heights.size() + boxes_m.size(); }
};

/// The same for all views.
struct BlockBounds {
  static constexpr int kGroup = 8; ///< by as many blocks
  BoundsOfBlocks blocks, groups;
};
/// Cost: 1 ns a height, on the ellipsoid 3, on all cores.
BlockBounds block_bounds(const Grid& grid);

/// About the share of the ground that lies, as seen, lower than what stands two blocks in front of
/// it: nothing much is hidden as blocks where that is small. REQUIRES a view of all of the grid.
/// Cost: a look at two vertices for each four blocks.
double share_behind_ridges(const Grid& grid, const View& view);

struct SeenGroundRequest {
  XRange range;       ///< what is shown; may be infinite
  double tolerance_y; ///< ground less than this under the horizon is looked at
  /// Of a grid on the ellipsoid: as `EarthGridCutter` takes them.
  std::shared_ptr<const BorderPlaces> border = nullptr;
  const Box3* box_m = nullptr;
};

/// Blocks of which nothing is in the range, nearer than the view's near plane, or of which all is
/// under the horizon by more than the tolerance are left out; others may be left out or not, but
/// never one with anything to be seen. Nothing that the blocks left out hold hides anything of
/// those looked at.
///
/// The horizon is that of profiles some cells apart, as a lower bound in narrow columns of X: what
/// the surface hides is more. A block's upper bound is its greatest height.
/// REQUIRES the grid's `block_bounds`, and one that the ellipsoid turns no triangle of over. The
/// same on any number of cores. Cost: a look at each block, and 1 to 2 ns a height of those in the
/// range.
SeenGround find_seen_ground(const Grid& grid, const BlockBounds& bounds, const View& view,
                            const SeenGroundRequest& request);

} // namespace orograph
