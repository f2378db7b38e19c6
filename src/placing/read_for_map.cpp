// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/read_for_map.hpp"

#include "dem/read/read_terrain.hpp"
#include "placing/cell_on_page.hpp"
#include "placing/terrain_facts.hpp"
#include "placing/terrain_of_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace orograph {
namespace {

// 4096 x 4096: reading them takes 0.1 s, and a level of them another.
constexpr std::uint64_t kMostHeights = std::uint64_t{1} << 24;
// Cells that are read, along a page that the terrain fills, for one that is asked for. In
// perspective the nearest are twice as large as that, and chosen ones are 0.7 to 1.4 of what is
// asked.
constexpr double kCellsForOne = 2;

bool shows_whole_terrain(const MapSpec& spec) {
  const DetailSpec& detail = spec.style.detail;
  const bool is_level =
      !detail.of_file && !detail.error_mm && (!spec.ground_points || detail.cell_mm);
  return is_level && !spec.view.has_eye() && !spec.view.file && spec.check_of_file == 0;
}

// Whether the page shows cells that much larger than is asked that the raster's next smaller ones
// are nearer to it.
bool shows_large_cells(const TerrainData& whole, const MapSpec& spec, const SceneFile* solids) {
  const TerrainOfView terrain(whole, spec.view);
  const TerrainFacts facts = facts_of(*terrain);
  const PlacedView placed = placed_picture(*terrain, facts, spec, solids);
  return greatest_cell_mm(placed, std::get<Grid>(terrain->surface)) >
         std::numbers::sqrt2 * asked_size(spec.style).least_mm;
}

} // namespace

TerrainData read_for_map(const std::vector<std::string>& paths, const ReadOptions& options,
                         const MapSpec& spec, const SceneFile* solids,
                         const std::function<void(double)>& progress) {
  if (!shows_whole_terrain(spec)) return read_terrain(paths, options, progress);
  const double page_mm = std::max(spec.page.width_mm, spec.page.height_mm.value_or(0));
  ReadOptions of_page = options;
  of_page.large = LargeRasters{
      kMostHeights,
      static_cast<int>(std::ceil(kCellsForOne * page_mm / asked_size(spec.style).least_mm))};
  for (;;) {
    TerrainData terrain = read_terrain(paths, of_page, progress);
    const auto& read = terrain.larger_cells;
    if (!read || !shows_large_cells(terrain, spec, solids)) return terrain;
    // It isn't seen as a whole, or along its shorter side.
    of_page.large->least_cells = (std::min(read->columns, read->rows) - 1) / (read->step / 2);
  }
}

} // namespace orograph
