// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle of larger cells has its corners, and its diagonal, on the file's lattice, so it is
// parted into the file's triangles: the difference of both surfaces is flat on each of these, and
// greatest at a vertex of the file's.
//
// At a seam a vertex of the finer patch is drawn to the coarser one's edge, by no more than that
// one's departure there, and the triangles at it follow. So the finer patch is off by its own
// departure and its coarser neighbours', each of which gets half of what is allowed; the
// neighbour's at the scale that the page has all over it, and over the finer patches around.
#include "placing/certified_patches.hpp"

#include "geometry/blocked_points.hpp"
#include "placing/geodesy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <variant>

namespace orograph {
namespace {

// Whether no height of the file is farther than this from the triangles that a part has in cells of
// 2^level, and none is missing. Each is looked at once: on a border between two cells, with the
// latter. REQUIRES a part of whole cells.
template <class Height>
bool is_within(const Grid& grid, const Heights<Height>& heights, const PatchPlace& part, int level,
               double most_m) {
  const int step = 1 << level;
  const double share = 1.0 / step;
  for (int row = static_cast<int>(part.first_row); row < part.last_row; row += step)
    for (int column = static_cast<int>(part.first_column); column < part.last_column;
         column += step) {
      const auto at = [&](int c, int r) {
        return static_cast<double>(heights[grid.index(column + c, row + r)]);
      };
      const double nw = at(0, 0), ne = at(step, 0), sw = at(0, step), se = at(step, step);
      bool is_off = false;
      const int columns = column + step < part.last_column ? step : step + 1,
                rows = row + step < part.last_row ? step : step + 1;
      for (int r = 0; r < rows; ++r) {
        const double y = r * share;
        const Height* const line = heights.data() + grid.index(column, row + r);
        // On the upper side of the diagonal x > y.
        for (int c = 0; c < std::min(r + 1, columns); ++c)
          is_off |= !(std::abs(nw + (sw - nw) * y + (se - sw) * (c * share) - line[c]) <= most_m);
        for (int c = r + 1; c < columns; ++c)
          is_off |= !(std::abs(nw + (ne - nw) * (c * share) + (se - ne) * y - line[c]) <= most_m);
      }
      if (is_off) return false;
    }
  return true;
}

PatchPlace with_neighbours(const Grid& grid, const PatchPlace& part) {
  const double wide = 0.5 * (part.last_column - part.first_column),
               high = 0.5 * (part.last_row - part.first_row);
  return {std::max(part.first_column - wide, 0.0),
          std::min(part.last_column + wide, grid.columns - 1.0),
          std::max(part.first_row - high, 0.0), std::min(part.last_row + high, grid.rows - 1.0)};
}

bool is_of_whole_cells(const PatchPlace& part, int level) {
  const auto is_whole = [&](double vertices) {
    return std::fmod(vertices, std::ldexp(1.0, level)) == 0;
  };
  return is_whole(part.last_column - part.first_column) && is_whole(part.last_row - part.first_row);
}

template <class IsWithin>
Patches certified(const Grid& grid, const HeightOnPage& heights, double most_mm,
                  const IsWithin& is_within_m) {
  return Patches(grid, {0, coarsest_level(grid)}, [&](int level, const PatchPlace& part) {
    if (!is_of_whole_cells(part, level)) return false;
    const double mm_per_m = heights.moves_mm(with_neighbours(grid, part), 1);
    const double most_m = mm_per_m > 0 ? 0.5 * most_mm / mm_per_m - heights.sag_m(level)
                                       : std::numeric_limits<double>::max();
    return most_m > 0 && (level == 0 || is_within_m(level, part, most_m));
  });
}

} // namespace

HeightOnPage::HeightOnPage(const Grid& grid, const PlacedView& placed)
    : HeightOnPage(grid, placed, HeightRanges(grid)) {}

HeightOnPage::HeightOnPage(const Grid& grid, const PlacedView& placed, HeightRanges heights)
    : grid_(grid), placed_(placed), heights_(std::move(heights)),
      is_round_(grid.is_on_earth() || placed.view.drop.any()) {
  const GridSteps steps = steps_of(grid);
  cell_m_ = length(steps.column_m) + length(steps.row_m);
}

// An edge of length L is L²/8R below the earth; a parallel of latitude bends aside by tan(latitude)
// times that, 12 times at 85 degrees, where slopes of up to 2 add their height.
double HeightOnPage::sag_m(int level) const {
  if (!is_round_) return 0;
  const double edge_m = std::ldexp(cell_m_, level);
  const double bend = grid_.is_on_earth() ? 24 : 1;
  return bend * edge_m * edge_m / (8 * kMeanEarthRadius_m);
}

Box3 HeightOnPage::box_of(const PatchPlace& part, const PartHeights& heights) const {
  Box3 box;
  for (const double column : {part.first_column, part.last_column})
    for (const double row : {part.first_row, part.last_row})
      for (const double height_m : {heights.low_m, heights.high_m})
        box.include(std::visit(
            [&](const auto& lattice) {
              return lattice.vertex_m(static_cast<int>(std::lround(column)),
                                      static_cast<int>(std::lround(row)), height_m);
            },
            grid_.lattice));
  if (is_round_) { // between the corners the ground rises, and bends aside
    const double across_m = std::hypot(box.high.x - box.low.x, box.high.y - box.low.y);
    const double bend_m = 2 * across_m * across_m / kMeanEarthRadius_m;
    box.low = box.low - Vec3{bend_m, bend_m, bend_m};
    box.high = box.high + Vec3{bend_m, bend_m, bend_m};
  }
  return box;
}

// Of the page's homogeneous coordinates the last one, which is linear in the box.
HeightOnPage::Depths HeightOnPage::depths(const Box3& box) const {
  Depths out{kInfinity, -kInfinity};
  for (int i = 0; i < 8; ++i) {
    const double depth = placed_.on_page(to_profile_frame(placed_.view, corner_of(box, i))).z;
    out = {std::min(out.least, depth), std::max(out.greatest, depth)};
  }
  return out;
}

double HeightOnPage::moves_mm(const PatchPlace& part, double departure_m) const {
  const PartHeights heights = heights_.of(part);
  if (heights.empty() || departure_m == 0) return 0;
  const Box3 box = box_of(part, heights);
  const View& view = placed_.view;
  // What the earth's roundness has a share in isn't exaggerated, nor made less of.
  const double up_m =
      departure_m * (is_round_ ? std::max(1.0, placed_.exaggeration) : placed_.exaggeration);
  if (placed_.panorama) {
    const Vec2 eye = view.depth_origin_m;
    const double away_m = std::hypot(std::max({box.low.x - eye.x, eye.x - box.high.x, 0.0}),
                                     std::max({box.low.y - eye.y, eye.y - box.high.y, 0.0}));
    return up_m * placed_.panorama->page.radius_mm / away_m;
  }
  // A place (x, y) = (X, Y) / W moves by (X' - x W', Y' - y W') / W for each metre up.
  const ProfilePoint any{0, 1, view.eye_z_m};
  const Vec3 up = placed_.on_page({any.u, any.v, any.z + 1}) - placed_.on_page(any);
  const auto [depth, greatest] = depths(box);
  if (greatest <= 0) return 0;
  if (depth <= 0) return kInfinity;
  constexpr double kBeside_mm = 1; // a point may come from beside the frame
  double most = 0;
  for (const double x : {placed_.frame_mm.low.x - kBeside_mm, placed_.frame_mm.high.x + kBeside_mm})
    for (const double y :
         {placed_.frame_mm.low.y - kBeside_mm, placed_.frame_mm.high.y + kBeside_mm})
      most = std::max(most, std::hypot(up.x - x * up.z, up.y - y * up.z));
  return up_m * most / depth;
}

Patches certified_patches(const Grid& grid, const HeightOnPage& heights, double most_mm) {
  return certified(grid, heights, most_mm, [&](int level, const PatchPlace& part, double most_m) {
    return std::visit(
        [&](const auto& values) { return is_within(grid, values, part, level, most_m); },
        grid.heights_m);
  });
}

Patches certified_patches(const Grid& raster, const NestedCells& cells, const HeightOnPage& heights,
                          double most_mm) {
  return certified(raster, heights, most_mm, [&](int level, const PatchPlace& part, double most_m) {
    const int side = kPatchCells << level;
    return cells
               .departure(level, static_cast<int>(part.first_column) / side,
                          static_cast<int>(part.first_row) / side)
               .greatest_m <= most_m;
  });
}

double greatest_error_mm(const Patches& patches, const std::vector<Departure>& departures,
                         const HeightOnPage& heights) {
  const std::vector<Patch>& all = patches.patches();
  std::map<std::tuple<int, std::int64_t, std::int64_t>, std::size_t> numbers;
  for (std::size_t i = 0; i < all.size(); ++i)
    numbers[{all[i].level, all[i].column, all[i].row}] = i;
  double greatest = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Patch& patch = all[i];
    const PatchPlace part = patches.place_of(patch);
    double beside_m = 0;
    for (const auto& [across, down] :
         std::array<std::array<std::int64_t, 2>, 4>{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}}) {
      const std::int64_t column = patch.column + across, row = patch.row + down;
      if (column < 0 || row < 0) continue;
      const auto found = numbers.find({patch.level + 1, column / 2, row / 2});
      if (found != numbers.end())
        beside_m = std::max(beside_m,
                            departures[found->second].greatest_m + heights.sag_m(patch.level + 1));
    }
    const double own_m =
        patch.level > 0 ? departures[i].greatest_m + heights.sag_m(patch.level) : 0;
    greatest = std::max(greatest, heights.moves_mm(part, own_m + beside_m));
  }
  return greatest;
}

} // namespace orograph
