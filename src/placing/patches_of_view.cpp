// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/patches_of_view.hpp"

#include "dem/extent.hpp"
#include "dem/limit_lean.hpp"
#include "placing/places.hpp"
#include "placing/sector.hpp"
#include "profiles/border_places.hpp"
#include "profiles/outline.hpp"
#include "view/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace orograph {
namespace {

// Of 289 vertices each: a million and a half take a second.
constexpr std::size_t kMostPatches = 6000;
constexpr double kCellsAboutEye = 1.5;
// Ground so little under the horizon, as a slope, may come up when it is smoothed.
constexpr double kBesideHorizon = 0.002;

// Of the page's own: more than ground leans on the ellipsoid, and than a border's vertices reach.
constexpr double kBesidePage = 0.02;

Vec2 ground_m(const Grid& grid, double column, double row) {
  // Of the nearest vertex, which is near enough.
  const int c = static_cast<int>(std::lround(column)), r = static_cast<int>(std::lround(row));
  const Vec3 at = std::visit([&](const auto& l) { return l.vertex_m(c, r, 0); }, grid.lattice);
  return {at.x, at.y};
}

double outside(double at, double low, double high) {
  return std::max({low - at, at - high, 0.0});
}

double greatest_side_m(const Grid& grid) {
  const GridSteps steps = steps_of(grid);
  return std::max(length(steps.column_m), length(steps.row_m));
}

std::optional<XRange> range_of_page(const PlacedView& placed) {
  if (placed.panorama || shows_beside(placed.view)) return std::nullopt;
  Sector sector;
  sector.view = placed.view;
  return page_range(sector);
}

// What there is to know of a grid on the ellipsoid.
struct OnEarth {
  std::shared_ptr<const BorderPlaces> border;
  Box3 box_m;
  bool is_turned_over = false;
};

OnEarth on_earth(const Grid& grid) {
  if (!grid.is_on_earth()) return {};
  const SurfaceExtent extent = extent_of(grid);
  return {std::make_shared<const BorderPlaces>(border_places(grid, border_edges(grid, false))),
          extent.box, extent.turned_over > 0};
}

// Blocks of cells of which something may be seen; none where all may.
std::optional<SeenGround> seen_ground(const Grid& grid, const BlockBounds& bounds,
                                      const PlacedView& placed, const OnEarth& on_earth) {
  if (on_earth.is_turned_over) return std::nullopt;
  std::vector<Sector> sectors;
  if (placed.panorama)
    sectors = sectors_of(*placed.panorama, placed.view);
  else if (!shows_beside(placed.view))
    sectors.emplace_back().view = placed.view;
  std::optional<SeenGround> seen;
  for (const Sector& sector : sectors) {
    const SeenGround here =
        find_seen_ground(grid, bounds, sector.view,
                         {page_range(sector), kBesideHorizon, on_earth.border, &on_earth.box_m});
    if (seen)
      seen->add(here);
    else
      seen = here;
  }
  return seen;
}

// Whether any block that touches a part is looked at.
bool sees_some(const SeenGround& seen, const PatchPlace& part) {
  const auto first = [](double vertex) { return static_cast<int>(vertex) / SeenGround::kSide; };
  const auto last = [](double vertex, int blocks) {
    return std::min(static_cast<int>(std::ceil(vertex)) / SeenGround::kSide, blocks - 1);
  };
  for (int row = first(part.first_row); row <= last(part.last_row, seen.rows); ++row)
    for (int column = first(part.first_column); column <= last(part.last_column, seen.columns);
         ++column)
      if (seen.seen[seen.index(column, row)] != 0) return true;
  return false;
}

} // namespace

bool stands_over_ground(const ViewSpec& view, const TerrainData& terrain,
                        const TerrainFacts& facts) {
  const bool is_eyes = view.projection == Projection::perspective || is_panorama(view.projection);
  if (!view.has_eye() || view.file || !is_eyes) return false;
  ViewRequest request;
  request.exaggeration = exaggeration_of(view, facts.extent.box);
  place_eye(request, view, terrain);
  return request.eye_m && stands_over(std::get<Grid>(terrain.surface), facts.extent.blocks.boxes,
                                      {request.eye_m->x, request.eye_m->y});
}

ScaleOnPage::ScaleOnPage(const Grid& grid, const GroundRanges& ranges, const PlacedView& placed,
                         const Grid* raster)
    : grid_(grid), raster_(raster), raster_cell_m_(raster ? greatest_side_m(*raster) : 0),
      placed_(placed), page_(range_of_page(placed)),
      seen_(seen_ground(
          grid, ranges.blocks, placed,
          {placed.for_cutters.of_earth_grid, placed.extent.box, placed.extent.turned_over > 0})),
      heights_(ranges.heights),
      mm_per_radian_(placed.panorama ? placed.panorama->page.radius_mm
                                     : placed.mm_per_step({0, 1, placed.view.eye_z_m}, {1, 0, 0})) {
}

void ScaleOnPage::look_at_cells(const GridPart& window, Grid cells) {
  const bool has_ground = std::visit(
      [](const auto& heights_m) {
        return std::ranges::any_of(heights_m, [](auto height) { return !std::isnan(height); });
      },
      cells.heights_m);
  if (!has_ground) return;
  if (cells.is_on_earth()) limit_lean(cells);
  if (auto seen = seen_ground(cells, block_bounds(cells), placed_, on_earth(cells)))
    own_cells_.emplace(window, std::move(*seen));
}

// From the eye to the nearest ground of a part, whichever way it is turned.
Vec2 ScaleOnPage::beyond_eye_m(const PatchPlace& part) const {
  const Vec2 eye = placed_.view.depth_origin_m;
  Box2 ground;
  for (const double column : {part.first_column, part.last_column})
    for (const double row : {part.first_row, part.last_row})
      ground.include(ground_m(raster_ ? *raster_ : grid_, column, row));
  return {outside(eye.x, ground.low.x, ground.high.x), outside(eye.y, ground.low.y, ground.high.y)};
}

// An eye stands on the raster's own ground, whether the page shows it or not. At a patch's border
// that is so where the one beyond has the raster's cells as well.
bool ScaleOnPage::is_at_eye(Vec2 beyond_m) const {
  return raster_ && std::max(beyond_m.x, beyond_m.y) <= kCellsAboutEye * raster_cell_m_;
}

double ScaleOnPage::mm_per_m(const PatchPlace& part) const {
  const Vec2 beyond_m = beyond_eye_m(part);
  if (is_at_eye(beyond_m)) return std::numeric_limits<double>::infinity();
  if (is_beside_page(part) || !is_shown(part)) return 0;
  const PartHeights heights = heights_.of(in_grid(part));
  if (heights.empty()) return 0;
  const View& view = placed_.view;
  return mm_per_radian_ / length(Vec3{beyond_m.x, beyond_m.y,
                                      outside(view.eye_z_m, heights.low_m * view.exaggeration,
                                              heights.high_m * view.exaggeration)});
}

bool ScaleOnPage::is_beside_page(const PatchPlace& part) const {
  if (!page_ || is_at_eye(beyond_eye_m(part))) return false;
  bool is_left = true, is_right = true, is_behind = true;
  for (const double column : {part.first_column, part.last_column})
    for (const double row : {part.first_row, part.last_row}) {
      const Vec2 at = ground_m(raster_ ? *raster_ : grid_, column, row);
      const ProfilePoint corner = to_profile_frame(placed_.view, {at.x, at.y, 0});
      is_left &= corner.u < (page_->begin - kBesidePage) * corner.v;
      is_right &= corner.u > (page_->end + kBesidePage) * corner.v;
      is_behind &= corner.v < 0;
    }
  return is_left || is_right || is_behind;
}

PatchPlace ScaleOnPage::in_grid(const PatchPlace& part) const {
  if (!raster_) return part;
  const double across = (grid_.columns - 1.0) / (raster_->columns - 1),
               down = (grid_.rows - 1.0) / (raster_->rows - 1);
  return {part.first_column * across, part.last_column * across, part.first_row * down,
          part.last_row * down};
}

bool ScaleOnPage::is_shown(const PatchPlace& part) const {
  if (seen_ && !sees_some(*seen_, in_grid(part))) return false;
  if (!own_cells_) return true;
  const GridPart& window = own_cells_->window;
  const PatchPlace in_window{part.first_column - window.first_column,
                             part.last_column - window.first_column,
                             part.first_row - window.first_row, part.last_row - window.first_row};
  const bool is_inside = in_window.first_column >= 0 && in_window.first_row >= 0 &&
                         in_window.last_column < window.columns && in_window.last_row < window.rows;
  return !is_inside || sees_some(own_cells_->seen, in_window);
}

Patches patches_of_view(const Grid& grid, const ScaleOnPage& scale, const CellSizes& sizes,
                        int finest) {
  const double cell_m = greatest_side_m(grid);
  const int coarsest = coarsest_level(grid);
  // What is beside the page is a few patches, however many vertices the grid has.
  const int coarsest_beside = coarsest_level(grid, std::numeric_limits<int>::max());
  const auto wanted = [&](const PatchPlace& part) {
    const double cell_mm = cell_m * scale.mm_per_m(part);
    if (cell_mm < sizes.least_mm)
      return std::min<int>(coarsest,
                           cell_mm > 0 ? static_cast<int>(std::log2(sizes.least_mm / cell_mm) + 0.5)
                                       : coarsest);
    if (cell_mm > sizes.most_mm)
      return std::isfinite(cell_mm)
                 ? std::max(kFinestLevel,
                            -static_cast<int>(std::log2(cell_mm / sizes.most_mm) + 0.5))
                 : kFinestLevel;
    return 0;
  };
  for (;; ++finest) {
    Patches patches(grid, {finest, coarsest_beside}, [&](int level, const PatchPlace& part) {
      return level > coarsest ? scale.is_beside_page(part)
                              : std::max(finest, wanted(part)) >= level;
    });
    if (finest == 0 || patches.patches().size() <= kMostPatches) return patches;
  }
}

} // namespace orograph
