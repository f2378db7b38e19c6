// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/patches_of_view.hpp"

#include "geometry/on_all_cores.hpp"
#include "placing/sector.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace orograph {
namespace {

// As finer ones of whole levels: they show no more.
constexpr int kFinest = -3;
// Of 289 vertices each: a million and a half take a second.
constexpr std::size_t kMostPatches = 6000;
// Ground so little under the horizon, as a slope, may come up when it is smoothed.
constexpr double kBesideHorizon = 0.002;

Vec2 ground_m(const Grid& grid, double column, double row) {
  // Of the nearest vertex, which is near enough.
  const int c = static_cast<int>(std::lround(column)), r = static_cast<int>(std::lround(row));
  const Vec3 at = std::visit([&](const auto& l) { return l.vertex_m(c, r, 0); }, grid.lattice);
  return {at.x, at.y};
}

double outside(double at, double low, double high) {
  return std::max({low - at, at - high, 0.0});
}

// Blocks of cells of which something may be seen; none where all may.
std::optional<SeenGround> seen_ground(const Grid& grid, const PlacedView& placed) {
  if (placed.extent.turned_over > 0) return std::nullopt;
  std::vector<Sector> sectors;
  if (placed.panorama)
    sectors = sectors_of(*placed.panorama, placed.view);
  else if (!shows_beside(placed.view))
    sectors.emplace_back().view = placed.view;
  const BlockBounds bounds = block_bounds(grid);
  std::optional<SeenGround> seen;
  for (const Sector& sector : sectors) {
    const SeenGround here = find_seen_ground(
        grid, bounds, sector.view,
        {page_range(sector), kBesideHorizon, placed.for_cutters.of_earth_grid, &placed.extent.box});
    if (seen)
      seen->add(here);
    else
      seen = here;
  }
  return seen;
}

} // namespace

ScaleOnPage::ScaleOnPage(const Grid& grid, const PlacedView& placed)
    : grid_(grid), placed_(placed), seen_(seen_ground(grid, placed)), heights_(grid),
      mm_per_radian_(placed.panorama ? placed.panorama->page.radius_mm
                                     : placed.mm_per_step({0, 1, placed.view.eye_z_m}, {1, 0, 0})) {
}

double ScaleOnPage::mm_per_m(const PatchPlace& part) const {
  if (!is_shown(part)) return 0;
  const View& view = placed_.view;
  const Vec2 eye = view.depth_origin_m;
  Box2 ground;
  for (const double column : {part.first_column, part.last_column})
    for (const double row : {part.first_row, part.last_row})
      ground.include(ground_m(grid_, column, row));
  const PartHeights heights = heights_.of(part);
  if (heights.empty()) return 0;
  return mm_per_radian_ / length(Vec3{outside(eye.x, ground.low.x, ground.high.x),
                                      outside(eye.y, ground.low.y, ground.high.y),
                                      outside(view.eye_z_m, heights.low_m * view.exaggeration,
                                              heights.high_m * view.exaggeration)});
}

bool ScaleOnPage::is_shown(const PatchPlace& part) const {
  if (!seen_) return true;
  const auto first = [](double vertex) { return static_cast<int>(vertex) / SeenGround::kSide; };
  const auto last = [](double vertex, int blocks) {
    return std::min(static_cast<int>(std::ceil(vertex)) / SeenGround::kSide, blocks - 1);
  };
  for (int row = first(part.first_row); row <= last(part.last_row, seen_->rows); ++row)
    for (int column = first(part.first_column); column <= last(part.last_column, seen_->columns);
         ++column)
      if (seen_->seen[seen_->index(column, row)] != 0) return true;
  return false;
}

Patches patches_of_view(const Grid& grid, const ScaleOnPage& scale, const CellSizes& sizes) {
  const GridSteps steps = steps_of(grid);
  const double cell_m = std::max(length(steps.column_m), length(steps.row_m));
  const int coarsest = coarsest_level(grid);
  const auto wanted = [&](const PatchPlace& part) {
    const double cell_mm = cell_m * scale.mm_per_m(part);
    if (cell_mm < sizes.least_mm)
      return std::min<int>(coarsest,
                           cell_mm > 0 ? static_cast<int>(std::log2(sizes.least_mm / cell_mm) + 0.5)
                                       : coarsest);
    if (cell_mm > sizes.most_mm)
      return std::isfinite(cell_mm)
                 ? std::max(kFinest, -static_cast<int>(std::log2(cell_mm / sizes.most_mm) + 0.5))
                 : kFinest;
    return 0;
  };
  for (int finest = kFinest;; ++finest) {
    Patches patches(grid, {finest, coarsest}, [&](int level, const PatchPlace& part) {
      return std::max(finest, wanted(part)) >= level;
    });
    if (finest == 0 || patches.patches().size() <= kMostPatches) return patches;
  }
}

} // namespace orograph
