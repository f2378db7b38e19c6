// SPDX-License-Identifier: GPL-3.0-or-later
// The heights that each of a grid's patches has of its own, before they are sewn together.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/patches.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace orograph {

/// Column and row, in cells of the finest level.
using PatchworkPlace = std::array<std::int64_t, 2>;

struct HashOfPlace {
  std::size_t operator()(const PatchworkPlace& place) const {
    return static_cast<std::size_t>(place[0]) * 0x9e3779b97f4a7c15U ^
           static_cast<std::size_t>(place[1]) * 0xc2b2ae3d27d4eb4fU;
  }
};

/// Of one patch: its lattice's columns and rows, and its heights there; NaN where there is none.
struct PatchHeights {
  std::vector<std::int64_t> columns, rows;
  std::vector<double> heights_m; ///< row-major

  double at(std::size_t i, std::size_t j) const { return heights_m[j * columns.size() + i]; }
};

/// Of all patches: larger cells have the grid's generalised heights, smaller ones its refined
/// heights, as whole levels have them. REQUIRES that grid and patches outlive it.
class HeightsOfPatches {
public:
  /// `is_kept` as of `generalised`; where it is empty larger cells aren't generalised but have the
  /// grid's heights at their vertices. Cost: some 10 ns a height of the grid in larger cells, 60 ns
  /// a height of smaller ones, on all cores.
  HeightsOfPatches(const Grid& grid, const Patches& patches,
                   const std::function<bool(int column, int row)>& is_kept);

  /// Of a patch, by its place in `patches.patches()`.
  const PatchHeights& operator[](std::size_t patch) const { return own_[patch]; }
  /// Of a level, at a vertex of a patch of that level.
  double at(int level, PatchworkPlace place) const;

private:
  PatchHeights heights_of(const Patch& patch,
                          const std::function<bool(int column, int row)>& is_kept) const;

  const Grid& grid_;
  const Patches& patches_;
  std::vector<PatchHeights> own_;
  /// Patches by their first place; no two have the same.
  std::unordered_map<PatchworkPlace, std::size_t, HashOfPlace> by_place_;
};

} // namespace orograph
