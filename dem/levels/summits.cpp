// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/summits.hpp"

#include "dem/levels/stretched_lattice.hpp"
#include "dem/levels/tops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

namespace orograph {
namespace {

// The highest vertex of a level within a cell of a place in it, before others that are as high.
// None where no height is drawn.
std::optional<Vec3> drawn_near(const Grid& level, int column, int row) {
  std::optional<Vec3> drawn;
  double drawn_m = -std::numeric_limits<double>::infinity();
  if (const double height = level.height_m(column, row); !std::isnan(height)) {
    drawn_m = height;
    drawn = level.vertex_m(column, row);
  }
  for (int r = std::max(0, row - 1); r <= std::min(level.rows - 1, row + 1); ++r)
    for (int c = std::max(0, column - 1); c <= std::min(level.columns - 1, column + 1); ++c)
      if (const double height = level.height_m(c, r); height > drawn_m) {
        drawn_m = height;
        drawn = level.vertex_m(c, r);
      }
  return drawn;
}

} // namespace

std::vector<Summit> summits_of(const Grid& grid, const Grid& level, std::size_t most) {
  const double per_column = (level.columns - 1.0) / (grid.columns - 1),
               per_row = (level.rows - 1.0) / (grid.rows - 1);
  const int side =
      std::max(1, static_cast<int>(kSummitsApart / std::min(1.0, std::max(per_column, per_row))));
  std::vector<Summit> summits;
  // One of which no height is drawn takes no other's place.
  for (const Top& top : tops_of(grid, side, most))
    if (const auto drawn = drawn_near(level, static_cast<int>(std::lround(top.column * per_column)),
                                      static_cast<int>(std::lround(top.row * per_row))))
      summits.push_back({grid.vertex_m(top.column, top.row), *drawn});
  return summits;
}

std::vector<Summit> summits_of(const LargerCells& file, const Grid& level) {
  const auto lattice = stretched_lattice(level, file.columns, file.rows);
  const double per_column = (level.columns - 1.0) / (file.columns - 1),
               per_row = (level.rows - 1.0) / (file.rows - 1);
  std::vector<Summit> summits;
  for (const Top& top : file.tops)
    if (const auto drawn = drawn_near(level, static_cast<int>(std::lround(top.column * per_column)),
                                      static_cast<int>(std::lround(top.row * per_row))))
      summits.push_back(
          {std::visit([&](const auto& l) { return l.vertex_m(top.column, top.row, top.height_m); },
                      lattice),
           *drawn});
  return summits;
}

namespace {

// The highest vertex of the patches within a cell of a place of the grid's, before others the one
// that is there.
std::optional<Vec3> drawn_near(const Patchwork& made, const Patches& patches, const Top& top) {
  const std::int64_t file = patches.cell(0), column = top.column * file, row = top.row * file;
  const std::int64_t reach = patches.cell(patches.coarsest_at(column, row));
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < made.places.size(); ++i) {
    const auto& [c, r] = made.places[i];
    if (std::abs(c - column) > reach || std::abs(r - row) > reach) continue;
    const double height_m = made.heights_m[i];
    if (!best || height_m > made.heights_m[*best] ||
        (height_m == made.heights_m[*best] && c == column && r == row))
      best = i;
  }
  return best ? std::optional(made.tin.vertices_m[*best]) : std::nullopt;
}

} // namespace

std::vector<Summit> summits_of(const Grid& grid, const Patchwork& made, const Patches& patches,
                               std::size_t most) {
  std::vector<Summit> summits;
  for (const Top& top : tops_of(grid, kSummitsApart, most))
    if (const auto drawn = drawn_near(made, patches, top))
      summits.push_back({grid.vertex_m(top.column, top.row), *drawn});
  return summits;
}

std::vector<Summit> summits_of(const LargerCells& file, const Grid& raster, const Patchwork& made,
                               const Patches& patches) {
  std::vector<Summit> summits;
  for (const Top& top : file.tops)
    if (const auto drawn = drawn_near(made, patches, top))
      summits.push_back(
          {std::visit([&](const auto& l) { return l.vertex_m(top.column, top.row, top.height_m); },
                      raster.lattice),
           *drawn});
  return summits;
}

} // namespace orograph
