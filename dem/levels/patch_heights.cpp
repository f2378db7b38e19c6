// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/patch_heights.hpp"

#include "dem/levels/generalise.hpp"
#include "dem/levels/part_of_grid.hpp"
#include "dem/levels/refine.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <limits>

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

} // namespace

HeightsOfPatches::HeightsOfPatches(const Grid& grid, const Patches& patches,
                                   const std::function<bool(int, int)>& is_kept)
    : grid_(grid), patches_(patches), own_(patches.patches().size()) {
  const std::vector<Patch>& all = patches.patches();
  on_all_cores(all.size(), [&](std::size_t i) { own_[i] = heights_of(all[i], is_kept); });
  for (std::size_t i = 0; i < all.size(); ++i)
    by_place_.emplace(PatchworkPlace{own_[i].columns.front(), own_[i].rows.front()}, i);
}

PatchHeights HeightsOfPatches::heights_of(const Patch& patch,
                                          const std::function<bool(int, int)>& is_kept) const {
  const std::int64_t cell = patches_.cell(patch.level), file = patches_.cell(0);
  PatchHeights out{lattice_of(patch.column, cell, patches_.columns()),
                   lattice_of(patch.row, cell, patches_.rows()),
                   {}};
  if (patch.level > 0 && is_kept) {
    out.heights_m = nested_heights(grid_, 1 << patch.level,
                                   {static_cast<std::size_t>(patch.column * kPatchCells),
                                    static_cast<std::size_t>(patch.row * kPatchCells),
                                    out.columns.size(), out.rows.size()},
                                   is_kept);
    return out;
  }
  out.heights_m.reserve(out.columns.size() * out.rows.size());
  if (patch.level >= 0) {
    for (const std::int64_t row : out.rows)
      for (const std::int64_t column : out.columns)
        out.heights_m.push_back(
            grid_.height_m(static_cast<int>(column / file), static_cast<int>(row / file)));
    return out;
  }
  const GridPart part = looked_at(grid_, out, file);
  const Grid fine = refined(part_of_grid(grid_, part), 1 << -patch.level);
  for (const std::int64_t row : out.rows)
    for (const std::int64_t column : out.columns)
      out.heights_m.push_back(
          fine.height_m(static_cast<int>((column - part.first_column * file) / cell),
                        static_cast<int>((row - part.first_row * file) / cell)));
  return out;
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
