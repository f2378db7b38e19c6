// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/terrains_for_maps.hpp"

#include "dem/read/raster_parts.hpp"
#include "dem/read/read_terrain.hpp"
#include "placing/cell_on_page.hpp"
#include "placing/patches_of_raster.hpp"
#include "placing/terrain_facts.hpp"
#include "placing/terrain_of_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <utility>

namespace orograph {
namespace {

// 4096 x 4096: reading them takes 0.1 s, and a level of them another.
constexpr std::uint64_t kMostHeights = std::uint64_t{1} << 24;
// Cells that are read, along a page that the terrain fills, for one that is asked for. In
// perspective the nearest are twice as large as that, and chosen ones are 0.7 to 1.4 of what is
// asked.
constexpr double kCellsForOne = 2;

bool shows_level(const MapSpec& spec) {
  const DetailSpec& detail = spec.style.detail;
  const bool is_level =
      !detail.of_file && !detail.error_mm && (!spec.ground_points || detail.cell_mm);
  // Lines that are draped over patches have no lattice to lie on, if it is in degrees.
  const bool has_drape = spec.view.has_eye() && spec.style.asks_for("drape");
  return is_level && !spec.view.file && spec.check_of_file == 0 && !has_drape;
}

// What is asked of a raster that is large: cells along its shorter side; 0: all of them.
int cells_of_page(const MapSpec& spec) {
  if (!shows_level(spec)) return 0;
  const double page_mm = std::max(spec.page.width_mm, spec.page.height_mm.value_or(0));
  return static_cast<int>(std::ceil(kCellsForOne * page_mm / asked_size(spec.style).least_mm));
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

// With what an eye sees so near that it is to be drawn in the raster's own cells. Which these are
// is known better once the ground under the eye is. Null where the eye isn't over the terrain.
std::shared_ptr<const TerrainData>
with_parts_near_eye(const TerrainData& whole, const std::vector<std::string>& paths,
                    const ReadOptions& options, const MapSpec& spec, const SceneFile* solids) {
  const TerrainOfView terrain(whole, spec.view);
  const TerrainFacts facts = facts_of(*terrain);
  if (!stands_over_ground(spec.view, *terrain, facts)) return nullptr;
  const PlacedView placed = placed_picture(*terrain, facts, spec, solids);
  TerrainData framed = *terrain;
  for (;;) {
    std::vector<RasterPart>& parts = framed.larger_cells->parts;
    const std::vector<GridPart> missing = PatchesOfRaster(framed, placed, spec).missing();
    if (missing.empty()) {
      TerrainData out = whole;
      out.larger_cells->parts = std::move(parts);
      return std::make_shared<const TerrainData>(std::move(out));
    }
    std::ranges::move(read_raster_parts(paths, options, missing), std::back_inserter(parts));
    std::ranges::sort(parts, {}, [](const RasterPart& part) {
      return std::pair(part.at.first_row, part.at.first_column);
    });
  }
}

} // namespace

TerrainsForMaps::TerrainsForMaps(std::vector<std::string> paths, ReadOptions options,
                                 const SceneFile* solids)
    : paths_(std::move(paths)), options_(std::move(options)), solids_(solids) {}

std::shared_ptr<const TerrainData>
TerrainsForMaps::of(const MapSpec& spec, const std::function<void(double)>& progress) {
  for (int least_cells = cells_of_page(spec);;) {
    std::shared_ptr<const TerrainData> terrain = read(least_cells, progress);
    const auto& larger = terrain->larger_cells;
    if (!larger || least_cells == 0) return terrain;
    if (spec.view.has_eye())
      if (auto with_parts = with_parts_near_eye(*terrain, paths_, options_, spec, solids_))
        return with_parts;
    if (!shows_large_cells(*terrain, spec, solids_)) return terrain;
    // It isn't seen as a whole, or along its shorter side.
    least_cells = (std::min(larger->columns, larger->rows) - 1) / (larger->step / 2);
  }
}

std::shared_ptr<const TerrainData> TerrainsForMaps::before_views(const MapSpec& spec) {
  return read(cells_of_page(spec), {});
}

std::shared_ptr<const TerrainData>
TerrainsForMaps::read(int least_cells, const std::function<void(double)>& progress) {
  const std::lock_guard lock(mutex_);
  if (not_large_) return not_large_;
  std::shared_ptr<const TerrainData>& kept = by_cells_[least_cells];
  if (kept) return kept;
  ReadOptions options = options_;
  if (least_cells > 0) options.large = LargeRasters{kMostHeights, least_cells};
  kept = std::make_shared<const TerrainData>(read_terrain(paths_, options, progress));
  if (least_cells > 0 && !kept->larger_cells) not_large_ = kept;
  return kept;
}

} // namespace orograph
