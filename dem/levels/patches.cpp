// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/patches.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

// In a level, of the one that holds a patch of the next finer.
std::int64_t half(std::int64_t number) {
  return number / 2;
}

} // namespace

int coarsest_level(const Grid& grid, int most) {
  int level = 0;
  while (level < most && std::min(grid.columns, grid.rows) > (kPatchCells << level)) ++level;
  return level;
}

Patches::Patches(const Grid& grid, PatchLevels levels, const IsRight& is_right) : levels_(levels) {
  columns_ = static_cast<std::int64_t>(grid.columns - 1) * cell(0);
  rows_ = static_cast<std::int64_t>(grid.rows - 1) * cell(0);
  for (int level = levels.finest; level <= levels.coarsest; ++level) {
    const std::int64_t side = kPatchCells * cell(level);
    Level& of_level =
        parted_.emplace_back(Level{(columns_ + side - 1) / side, (rows_ + side - 1) / side, {}});
    of_level.parted.assign(static_cast<std::size_t>(of_level.across * of_level.down), false);
  }
  const Level& top = of(levels.coarsest);
  for (std::int64_t row = 0; row < top.down; ++row)
    for (std::int64_t column = 0; column < top.across; ++column)
      ask({levels.coarsest, column, row}, is_right);
  balance();
  for (std::int64_t row = 0; row < top.down; ++row)
    for (std::int64_t column = 0; column < top.across; ++column)
      list({levels.coarsest, column, row});
}

PatchPlace Patches::place_of(const Patch& patch) const {
  const std::int64_t side = kPatchCells * cell(patch.level);
  const auto at = [&](std::int64_t number, std::int64_t end) {
    return std::ldexp(static_cast<double>(std::min(number * side, end)), levels_.finest);
  };
  return {at(patch.column, columns_), at(patch.column + 1, columns_), at(patch.row, rows_),
          at(patch.row + 1, rows_)};
}

void Patches::ask(const Patch& patch, const IsRight& is_right) {
  if (patch.level == levels_.finest) return;
  throw_if_stopped();
  if (is_right(patch.level, place_of(patch))) return;
  Level& level = of(patch.level);
  level.parted[static_cast<std::size_t>(patch.row * level.across + patch.column)] = true;
  const Level& finer = of(patch.level - 1);
  for (const std::int64_t row : {2 * patch.row, 2 * patch.row + 1})
    for (const std::int64_t column : {2 * patch.column, 2 * patch.column + 1})
      if (column < finer.across && row < finer.down) ask({patch.level - 1, column, row}, is_right);
}

// What is beside a parted patch is a patch of its level, or parted as well: the next coarser one
// that would hold it is parted. From the finest level on, for each of which all is known then.
void Patches::balance() {
  for (int level = levels_.finest + 1; level < levels_.coarsest; ++level) {
    const Level& here = of(level);
    Level& coarser = of(level + 1);
    for (std::int64_t row = 0; row < here.down; ++row)
      for (std::int64_t column = 0; column < here.across; ++column) {
        if (!here.parted[static_cast<std::size_t>(row * here.across + column)]) continue;
        for (std::int64_t r = std::max<std::int64_t>(0, row - 1);
             r <= std::min(here.down - 1, row + 1); ++r)
          for (std::int64_t c = std::max<std::int64_t>(0, column - 1);
               c <= std::min(here.across - 1, column + 1); ++c)
            coarser.parted[static_cast<std::size_t>(half(r) * coarser.across + half(c))] = true;
      }
  }
}

void Patches::list(const Patch& patch) {
  const Level& level = of(patch.level);
  if (!level.parted[static_cast<std::size_t>(patch.row * level.across + patch.column)]) {
    patches_.push_back(patch);
    return;
  }
  const Level& finer = of(patch.level - 1);
  for (const std::int64_t row : {2 * patch.row, 2 * patch.row + 1})
    for (const std::int64_t column : {2 * patch.column, 2 * patch.column + 1})
      if (column < finer.across && row < finer.down) list({patch.level - 1, column, row});
}

bool Patches::is_parted(int level, std::int64_t column, std::int64_t row) const {
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return false;
  const Level& at = of(level);
  const std::int64_t side = kPatchCells * cell(level);
  return at.parted[static_cast<std::size_t>(row / side * at.across + column / side)];
}

int Patches::level_of_cell(std::int64_t column, std::int64_t row) const {
  int level = levels_.coarsest;
  while (level > levels_.finest && is_parted(level, column, row)) --level;
  return level;
}

int Patches::coarsest_at(std::int64_t column, std::int64_t row) const {
  int coarsest = levels_.finest;
  for (const std::int64_t c : {column - 1, column})
    for (const std::int64_t r : {row - 1, row})
      if (c >= 0 && r >= 0 && c < columns_ && r < rows_)
        coarsest = std::max(coarsest, level_of_cell(c, r));
  return coarsest;
}

} // namespace orograph
