// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/patch_heights.hpp"

#include "dem/levels/departure.hpp"
#include "dem/levels/generalise.hpp"
#include "dem/levels/part_of_grid.hpp"
#include "dem/levels/refine.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orograph {
namespace {

std::vector<std::int64_t> lattice_of(std::int64_t number, std::int64_t cell, std::int64_t end) {
  std::vector<std::int64_t> places;
  for (std::int64_t k = 0; k <= kPatchCells; ++k) {
    const std::int64_t at = std::min((number * kPatchCells + k) * cell, end);
    if (places.empty() || at > places.back()) places.push_back(at);
  }
  return places;
}

// What a patch's refined heights look at: its cells, and those beside them.
GridPart looked_at(const Grid& grid, const PatchHeights& lattice, std::int64_t file) {
  const auto first = [&](std::int64_t place) {
    return static_cast<int>(std::max<std::int64_t>(0, place / file - 1));
  };
  const auto end = [&](std::int64_t place, int vertices) {
    return std::min(vertices, static_cast<int>((place + file - 1) / file) + 2);
  };
  GridPart part{first(lattice.columns.front()), first(lattice.rows.front()), 0, 0};
  part.columns = end(lattice.columns.back(), grid.columns) - part.first_column;
  part.rows = end(lattice.rows.back(), grid.rows) - part.first_row;
  return part;
}

std::vector<double> heights_in_grid(const Grid& grid, const Patches& patches, const Patch& patch,
                                    const PatchHeights& lattice,
                                    const std::function<bool(int, int)>& is_kept) {
  const std::int64_t cell = patches.cell(patch.level), file = patches.cell(0);
  if (patch.level > 0 && is_kept)
    return nested_heights(grid, 1 << patch.level,
                          {static_cast<std::size_t>(patch.column * kPatchCells),
                           static_cast<std::size_t>(patch.row * kPatchCells),
                           lattice.columns.size(), lattice.rows.size()},
                          is_kept);
  std::vector<double> out;
  out.reserve(lattice.columns.size() * lattice.rows.size());
  if (patch.level >= 0) {
    for (const std::int64_t row : lattice.rows)
      for (const std::int64_t column : lattice.columns)
        out.push_back(grid.height_m(static_cast<int>(column / file), static_cast<int>(row / file)));
    return out;
  }
  const GridPart part = looked_at(grid, lattice, file);
  const Grid fine = refined(part_of_grid(grid, part), 1 << -patch.level);
  for (const std::int64_t row : lattice.rows)
    for (const std::int64_t column : lattice.columns)
      out.push_back(fine.height_m(static_cast<int>((column - part.first_column * file) / cell),
                                  static_cast<int>((row - part.first_row * file) / cell)));
  return out;
}

// At the vertices of smaller cells.
Departure departure_of_refined(const Grid& grid, std::int64_t file, const PatchHeights& own) {
  SumOfDepartures sum;
  for (std::size_t j = 0; j < own.rows.size(); ++j)
    for (std::size_t i = 0; i < own.columns.size(); ++i) {
      const int column = std::min(static_cast<int>(own.columns[i] / file), grid.columns - 2),
                row = std::min(static_cast<int>(own.rows[j] / file), grid.rows - 2);
      const double x = static_cast<double>(own.columns[i] - column * file) /
                       static_cast<double>(file),
                   y = static_cast<double>(own.rows[j] - row * file) / static_cast<double>(file);
      sum.add(own.at(i, j) - height_in_cell(grid.height_m(column, row),
                                            grid.height_m(column + 1, row),
                                            grid.height_m(column, row + 1),
                                            grid.height_m(column + 1, row + 1), x, y));
    }
  return sum.take();
}

} // namespace

double height_in_cell(const PatchHeights& own, std::size_t i, std::size_t j, double x, double y) {
  return height_in_cell(own.at(i, j), own.at(i + 1, j), own.at(i, j + 1), own.at(i + 1, j + 1), x,
                        y);
}

Departure SumOfDepartures::take() const {
  Departure out = of_;
  if (count_ > 0) out.rms_m = std::sqrt(out.rms_m / static_cast<double>(count_));
  return out;
}

Departure departure_of_patch(const Grid& cells, int first_column, int first_row,
                             const Patches& patches, const PatchHeights& own) {
  const std::int64_t file = patches.cell(0);
  SumOfDepartures sum;
  for (std::size_t j = 0; j + 1 < own.rows.size(); ++j)
    for (std::size_t i = 0; i + 1 < own.columns.size(); ++i) {
      const std::int64_t wide = own.columns[i + 1] - own.columns[i],
                         high = own.rows[j + 1] - own.rows[j];
      for (std::int64_t row = own.rows[j]; row < own.rows[j + 1]; row += file)
        for (std::int64_t column = own.columns[i]; column < own.columns[i + 1]; column += file)
          sum.add(height_in_cell(
                      own, i, j,
                      static_cast<double>(column - own.columns[i]) / static_cast<double>(wide),
                      static_cast<double>(row - own.rows[j]) / static_cast<double>(high)) -
                  cells.height_m(static_cast<int>(column / file) - first_column,
                                 static_cast<int>(row / file) - first_row));
    }
  return sum.take();
}

PatchSource patches_of_grid(const Grid& grid, const Patches& patches,
                            std::function<bool(int, int)> is_kept) {
  return {[&grid, &patches, is_kept = std::move(is_kept)](const Patch& patch,
                                                          const PatchHeights& lattice) {
            return heights_in_grid(grid, patches, patch, lattice, is_kept);
          },
          [&grid, &patches](const Patch& patch, const PatchHeights& own) {
            return patch.level < 0   ? departure_of_refined(grid, patches.cell(0), own)
                   : patch.level > 0 ? departure_of_patch(grid, 0, 0, patches, own)
                                     : Departure{};
          }};
}

HeightsOfPatches::HeightsOfPatches(const Patches& patches, const PatchSource& source)
    : patches_(patches), own_(patches.patches().size()) {
  const std::vector<Patch>& all = patches.patches();
  on_all_cores(all.size(), [&](std::size_t i) {
    const std::int64_t cell = patches.cell(all[i].level);
    own_[i].columns = lattice_of(all[i].column, cell, patches.columns());
    own_[i].rows = lattice_of(all[i].row, cell, patches.rows());
    own_[i].heights_m = source.heights_m(all[i], own_[i]);
  });
  for (std::size_t i = 0; i < all.size(); ++i)
    by_place_.emplace(PatchworkPlace{own_[i].columns.front(), own_[i].rows.front()}, i);
}

double HeightsOfPatches::at(int level, PatchworkPlace place) const {
  const std::int64_t cell = patches_.cell(level), side = kPatchCells * cell;
  // Up to four patches of a level have it; all of them have the same height there.
  for (const std::int64_t row : {place[1] / side, (place[1] - 1) / side})
    for (const std::int64_t column : {place[0] / side, (place[0] - 1) / side}) {
      const auto found = by_place_.find({column * side, row * side});
      if (found == by_place_.end() || patches_.patches()[found->second].level != level) continue;
      const PatchHeights& own = own_[found->second];
      const auto number = [](const std::vector<std::int64_t>& places, std::int64_t value) {
        return static_cast<std::size_t>(std::ranges::lower_bound(places, value) - places.begin());
      };
      return own.at(number(own.columns, place[0]), number(own.rows, place[1]));
    }
  return std::numeric_limits<double>::quiet_NaN(); // of no patch
}

} // namespace orograph
