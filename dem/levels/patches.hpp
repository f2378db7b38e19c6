// SPDX-License-Identifier: GPL-3.0-or-later
// Squares of a grid, each with cells of a size of its own: larger ones far from the eye, smaller
// ones at its feet (docs/decisions/0058-patches.md).
#pragma once

#include "dem/grid.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace orograph {

/// Cells of 2^level times the file's on a side, from the finest level to the coarsest.
struct PatchLevels {
  int finest = 0, coarsest = 0;
};

/// Cells that a patch has along a side, of its own.
constexpr int kPatchCells = 16;

/// Of a grid's rows and columns, whole at vertices.
struct PatchPlace {
  double first_column, last_column, first_row, last_row;
};

/// A patch has kPatchCells cells of 2^level of the file's on a side; fewer where the grid ends,
/// and the last ones are as narrow as what is left.
struct Patch {
  int level = 0;
  std::int64_t column = 0, row = 0; ///< among the patches of its level

  bool operator==(const Patch&) const = default;
};

/// Far ground isn't shown in larger cells than of this level.
constexpr int kCoarsestShown = 6;

/// The coarsest level that a grid's patches may have: one of them is as large as the grid's shorter
/// side.
int coarsest_level(const Grid& grid, int most = kCoarsestShown);

/// A grid's patches: together they are all of it, none lies on another, and two that touch differ
/// by one level at most.
class Patches {
public:
  /// Whether a patch of a level may be at a place.
  using IsRight = std::function<bool(int level, const PatchPlace&)>;

  /// Patches are the coarsest that `is_right` lets be of a level at their place, or finer where
  /// those beside them ask for it; the finest are right anywhere. REQUIRES finest <= 0 <= coarsest.
  /// Cost: that of `is_right` for each patch, four thirds of it.
  Patches(const Grid& grid, PatchLevels levels, const IsRight& is_right);

  PatchLevels levels() const { return levels_; }
  /// Each beside the one before it, as far as may be.
  const std::vector<Patch>& patches() const { return patches_; }

  PatchPlace place_of(const Patch& patch) const;

  // Places in cells of the finest level, which divide all others: whole numbers.

  /// One cell of a level, in them.
  std::int64_t cell(int level) const { return std::int64_t{1} << (level - levels_.finest); }
  std::int64_t columns() const { return columns_; } ///< where the grid ends
  std::int64_t rows() const { return rows_; }
  /// The coarsest level of the patches that touch a place of the grid.
  int coarsest_at(std::int64_t column, std::int64_t row) const;
  /// Whether the patch of that level that has a cell is parted into four, or into more. A cell
  /// outside of the grid is of none.
  bool is_parted(int level, std::int64_t column, std::int64_t row) const;

private:
  struct Level {
    std::int64_t across, down; ///< patches
    std::vector<bool> parted;
  };
  Level& of(int level) { return parted_[static_cast<std::size_t>(level - levels_.finest)]; }
  const Level& of(int level) const {
    return parted_[static_cast<std::size_t>(level - levels_.finest)];
  }
  void ask(const Patch& patch, const IsRight& is_right);
  void balance();
  void list(const Patch& patch);
  int level_of_cell(std::int64_t column, std::int64_t row) const;

  PatchLevels levels_;
  std::int64_t columns_, rows_;
  std::vector<Level> parted_;
  std::vector<Patch> patches_;
};

} // namespace orograph
