// SPDX-License-Identifier: GPL-3.0-or-later
// The heights that each of a terrain's patches has of its own, before they are sewn together.
#pragma once

#include "dem/grid.hpp"
#include "dem/levels/departure.hpp"
#include "dem/levels/patches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

/// What patches are made of. Asked from several threads.
struct PatchSource {
  /// Heights at a patch's columns and rows. Patches of a level have the same at the same place.
  std::function<std::vector<double>(const Patch&, const PatchHeights& lattice)> heights_m;
  /// How far the patch is from what it stands for.
  std::function<Departure(const Patch&, const PatchHeights&)> departure;
};

/// A grid: larger cells have its generalised heights, smaller ones its refined heights, as whole
/// levels have them. `is_kept` as of `generalised`; where it is empty larger cells aren't
/// generalised but have the grid's heights at their vertices. REQUIRES that grid and patches
/// outlive it. Cost: some 10 ns a height of the grid in larger cells, 60 ns a height of smaller
/// ones.
PatchSource patches_of_grid(const Grid& grid, const Patches& patches,
                            std::function<bool(int column, int row)> is_kept);

/// Within the patch's cell after column i and row j, a share of it farther; NaN where a corner that
/// has a part in it has no height.
double height_in_cell(const PatchHeights& own, std::size_t i, std::size_t j, double x, double y);

/// Of heights; NaN isn't counted.
class SumOfDepartures {
public:
  void add(double apart_m) {
    if (std::isnan(apart_m)) return;
    of_.greatest_m = std::max(of_.greatest_m, std::abs(apart_m));
    of_.rms_m += apart_m * apart_m;
    ++count_;
  }
  Departure take() const;

private:
  Departure of_;
  std::size_t count_ = 0;
};

/// How far a patch of cells that aren't smaller than the file's is from the file's heights. `cells`
/// are these from a column and a row on, and all of the patch's are among them.
Departure departure_of_patch(const Grid& cells, int first_column, int first_row,
                             const Patches& patches, const PatchHeights& own);

/// Of all patches.
class HeightsOfPatches {
public:
  /// REQUIRES that `patches` outlives it. Calls the source on all cores.
  HeightsOfPatches(const Patches& patches, const PatchSource& source);

  /// Of a patch, by its place in `patches.patches()`.
  const PatchHeights& operator[](std::size_t patch) const { return own_[patch]; }
  /// Of a level, at a vertex of a patch of that level.
  double at(int level, PatchworkPlace place) const;

private:
  const Patches& patches_;
  std::vector<PatchHeights> own_;
  /// Patches by their first place; no two have the same.
  std::unordered_map<PatchworkPlace, std::size_t, HashOfPlace> by_place_;
};

} // namespace orograph
