// SPDX-License-Identifier: GPL-3.0-or-later
// How large cells are to be at each place of a terrain that an eye stands over.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/height_ranges.hpp"
#include "dem/levels/part_of_grid.hpp"
#include "dem/levels/patches.hpp"
#include "placing/cell_on_page.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_facts.hpp"
#include "profiles/seen_ground.hpp"

#include <optional>

namespace orograph {

/// Whether a spec's eye looks around from over a grid. Told at once: to place a panorama costs as
/// much as to draw one.
bool stands_over_ground(const ViewSpec& view, const TerrainData& terrain,
                        const TerrainFacts& facts);

/// How high a grid's ground is from place to place, found once for all eyes. Cost: two passes over
/// the heights on all cores.
struct GroundRanges {
  HeightRanges heights;
  BlockBounds blocks;

  explicit GroundRanges(const Grid& grid) : heights(grid), blocks(block_bounds(grid)) {}
};

/// How large a metre is on the page at places of a grid, from an eye in the landscape.
class ScaleOnPage {
public:
  /// REQUIRES a perspective view or a panorama of that grid, and its ranges; all outlive this.
  /// `raster`: parts are its, by its columns and rows, of whose lattice the grid is a level.
  ScaleOnPage(const Grid& grid, const GroundRanges& ranges, const PlacedView& placed,
              const Grid* raster = nullptr);

  /// Millimetres for a metre at the nearest ground of a part, whichever way it is turned; infinite
  /// at the eye, 0 where the view doesn't show it: beside the page, or hidden.
  double mm_per_m(const PatchPlace& part) const;
  /// Whether a part is beside the page or behind the eye as a whole, and not at its feet.
  bool is_beside_page(const PatchPlace& part) const;

  /// From now on what the raster's own cells hide of each other counts as hidden, too. REQUIRES a
  /// raster; `cells` are its in a window, NaN where they aren't known, which hides nothing.
  void look_at_cells(const GridPart& window, Grid cells);

private:
  Vec2 beyond_eye_m(const PatchPlace& part) const;
  bool is_at_eye(Vec2 beyond_m) const;
  bool is_shown(const PatchPlace& part) const;
  PatchPlace in_grid(const PatchPlace& part) const;

  const Grid& grid_;
  const Grid* raster_; ///< none: parts are the grid's
  double raster_cell_m_;
  const PlacedView& placed_;
  std::optional<XRange> page_;     ///< none: there is ground beside the eye on the page
  std::optional<SeenGround> seen_; ///< none: all may be seen
  struct OwnCells {
    GridPart window;
    SeenGround seen;
  };
  std::optional<OwnCells> own_cells_;
  const HeightRanges& heights_;
  double mm_per_radian_; ///< in the picture's middle
};

/// Cells are halved so often at most: finer ones of whole levels show no more.
constexpr int kFinestLevel = -3;

/// Patches whose cells have such sizes on the page, none finer than a level, and none so fine where
/// that would be too many. `scale` is of the grid's parts. Cost: some 100 ns a patch.
Patches patches_of_view(const Grid& grid, const ScaleOnPage& scale, const CellSizes& sizes,
                        int finest = kFinestLevel);

} // namespace orograph
