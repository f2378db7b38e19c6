// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/terrains_for_maps.hpp"

#include "dem/levels/raster_patches.hpp"
#include "dem/read/raster_parts.hpp"
#include "dem/read/read_terrain.hpp"
#include "geometry/free_memory.hpp"
#include "placing/cell_on_page.hpp"
#include "placing/certified_raster.hpp"
#include "placing/patches_of_raster.hpp"
#include "placing/terrain_facts.hpp"
#include "placing/terrain_of_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

namespace orograph {
namespace {

// 4096 x 4096: reading them takes 0.1 s, and a level of them another.
constexpr std::uint64_t kMostHeights = std::uint64_t{1} << 24;
// Cells that are read, along a page that the terrain fills, for one that is asked for. In
// perspective the nearest are twice as large as that, and chosen ones are 0.7 to 1.4 of what is
// asked.
constexpr double kCellsForOne = 2;

// What a view in a file cuts away is cut from the raster's own surface.
bool cuts(const MapSpec& spec) {
  return spec.view.file && spec.view.file->cuts();
}

bool shows_level(const MapSpec& spec) {
  const DetailSpec& detail = spec.style.detail;
  const bool is_level =
      !detail.of_file && (detail.error_mm || !spec.ground_points || detail.cell_mm);
  return is_level && !cuts(spec) && spec.check_of_file == 0;
}

// Lines that are draped over patches have no lattice to lie on, if it is in degrees.
bool needs_whole(const TerrainData& terrain, const MapSpec& spec) {
  const bool has_patches = spec.view.has_eye() || spec.style.detail.error_mm;
  return terrain.map.earth && has_patches && spec.style.asks_for("drape");
}

// What is asked of a raster that is large: cells along its shorter side; 0: all of them.
LevelAsked level_for(const MapSpec& spec) {
  if (!shows_level(spec)) return {};
  const double page_mm = std::max(spec.page.width_mm, spec.page.height_mm.value_or(0));
  return {static_cast<int>(std::ceil(kCellsForOne * page_mm / asked_size(spec.style).least_mm)),
          spec.style.detail.error_mm.has_value()};
}

// How many times as large as asked the page shows cells. Infinite where the eye of a view in a file
// stands over ground.
double times_too_large(const TerrainOfView& terrain, const TerrainFacts& facts, const MapSpec& spec,
                       const SceneFile* solids) {
  const PlacedView placed = placed_picture(*terrain, facts, spec, solids);
  return greatest_cell_mm(placed, std::get<Grid>(terrain->surface)) /
         asked_size(spec.style).least_mm;
}

// Adds to a terrain in its frame the parts of the raster that a drawing is found to miss, until it
// misses none. `missing` asks it.
void read_missing(TerrainData& framed, const std::vector<std::string>& paths,
                  const ReadOptions& options,
                  const std::function<std::vector<GridPart>()>& missing) {
  std::vector<RasterPart>& parts = framed.larger_cells->parts;
  for (;;) {
    const std::vector<GridPart> asked = missing();
    if (asked.empty()) return;
    std::ranges::move(read_raster_parts(paths, options, asked), std::back_inserter(parts));
    std::ranges::sort(parts, {}, [](const RasterPart& part) {
      return std::pair(part.at.first_row, part.at.first_column);
    });
  }
}

// What an eye sees so near that it is to be drawn in the raster's own cells. Which these are is
// known better once the ground under the eye is. None where the eye isn't over the terrain.
std::optional<std::vector<RasterPart>>
parts_near_eye(const TerrainOfView& terrain, const TerrainFacts& facts,
               const std::vector<std::string>& paths, const ReadOptions& options,
               const MapSpec& spec, const SceneFile* solids) {
  if (!stands_over_ground(spec.view, *terrain, facts)) return std::nullopt;
  const PlacedView placed = placed_picture(*terrain, facts, spec, solids);
  TerrainData framed = *terrain;
  const Grid& larger = std::get<Grid>(framed.surface);
  const GroundRanges ranges(larger);
  const Grid raster = lattice_of_raster(larger, *framed.larger_cells);
  std::optional<double> last_rise_m;
  read_missing(framed, paths, options, [&]() -> std::vector<GridPart> {
    const double rise_m = std::max(0.0, rise_of_raster(framed, raster, placed.view.depth_origin_m));
    if (rise_m == last_rise_m) return {}; // the eye stands where it stood when the parts were told
    last_rise_m = rise_m;
    return PatchesOfRaster(framed, ranges, placed, spec).missing();
  });
  return std::move(framed.larger_cells->parts);
}

// With what is to be drawn in the raster's own cells, or half as many, lest it be off by more than
// is asked. Null where its own surface is drawn quicker.
std::shared_ptr<const TerrainData>
with_parts_certified(const TerrainData& whole, const std::vector<std::string>& paths,
                     const ReadOptions& options, const MapSpec& spec, const SceneFile* solids) {
  const TerrainOfView terrain(whole, spec.view);
  const PlacedView placed = placed_picture(*terrain, facts_of(*terrain), spec, solids);
  TerrainData framed = *terrain;
  bool spares_enough = true;
  read_missing(framed, paths, options, [&] {
    const CertifiedRaster of(framed, placed, spec);
    spares_enough = of.spares_enough();
    if (!spares_enough) return std::vector<GridPart>{};
    check_memory(static_cast<double>(of.bytes_to_draw()), options.max_memory,
                 fmt::format("to draw {} within {} mm", whole.source, *spec.style.detail.error_mm),
                 "ask for a larger bound or a smaller page, keep a part with `bbox`");
    return of.missing();
  });
  if (!spares_enough) return nullptr;
  TerrainData out = whole;
  out.larger_cells->parts = std::move(framed.larger_cells->parts);
  return std::make_shared<const TerrainData>(std::move(out));
}

} // namespace

TerrainsForMaps::TerrainsForMaps(std::vector<std::string> paths, ReadOptions options,
                                 const SceneFile* solids)
    : paths_(std::move(paths)), options_(std::move(options)), solids_(solids) {}

TerrainForMap TerrainsForMaps::of(const MapSpec& spec,
                                  const std::function<void(double)>& progress) {
  for (LevelAsked asked = level_for(spec);;) {
    const std::shared_ptr<const TerrainData> whole = read(asked, progress);
    const auto& larger = whole->larger_cells;
    if (!larger) return {whole, nullptr};
    if (needs_whole(*whole, spec)) return {read({}, progress), nullptr};
    if (asked.with_nested) {
      auto with_parts = with_parts_certified(*whole, paths_, options_, spec, solids_);
      return {with_parts ? with_parts : read({}, progress), nullptr};
    }
    // What an eye has near by is of this map alone, and facts refer to their terrain.
    const auto of_eye = spec.view.has_eye() ? std::make_shared<TerrainData>(*whole) : nullptr;
    const std::shared_ptr<const TerrainData> out = of_eye ? of_eye : whole;
    const TerrainOfView terrain(*out, spec.view);
    const auto facts = std::make_shared<const TerrainFacts>(facts_of(*terrain));
    const auto of_whole = terrain.is_whole() ? facts : nullptr;
    if (of_eye)
      if (auto parts = parts_near_eye(terrain, *facts, paths_, options_, spec, solids_)) {
        of_eye->larger_cells->parts = std::move(*parts);
        return {out, of_whole};
      }
    // A half more or less than what is asked is as near as cells come.
    const double halvings =
        std::ceil(std::log2(times_too_large(terrain, *facts, spec, solids_)) - 0.5);
    if (!(halvings > 0)) return {whole, of_eye ? nullptr : of_whole};
    // It isn't seen as a whole, or along its shorter side.
    const double step = larger->step / std::exp2(halvings);
    if (step < 1) return {read({}, progress), nullptr};
    asked.least_cells = (std::min(larger->columns, larger->rows) - 1) / static_cast<int>(step);
  }
}

std::shared_ptr<const TerrainData> TerrainsForMaps::before_views(const MapSpec& spec) {
  return read(level_for(spec), {});
}

std::shared_ptr<const TerrainData>
TerrainsForMaps::read(LevelAsked asked, const std::function<void(double)>& progress) {
  const std::lock_guard lock(mutex_);
  if (not_large_) return not_large_;
  std::shared_ptr<const TerrainData>& kept = by_level_[asked];
  if (kept) return kept;
  ReadOptions options = options_;
  if (asked.least_cells > 0)
    options.large = LargeRasters{kMostHeights, asked.least_cells, asked.with_nested};
  kept = std::make_shared<const TerrainData>(read_terrain(paths_, options, progress));
  if (asked.least_cells > 0 && !kept->larger_cells) not_large_ = kept;
  return kept;
}

} // namespace orograph
