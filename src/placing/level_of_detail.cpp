// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/level_of_detail.hpp"

#include "dem/height_at.hpp"
#include "dem/levels/generalise.hpp"
#include "dem/levels/part_of_grid.hpp"
#include "dem/levels/patchwork.hpp"
#include "dem/levels/raster_patches.hpp"
#include "dem/levels/refine.hpp"
#include "dem/limit_lean.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "placing/cell_on_page.hpp"
#include "placing/certified_patches.hpp"
#include "placing/certified_raster.hpp"
#include "placing/land_part.hpp"
#include "placing/patches_of_raster.hpp"
#include "placing/patches_of_view.hpp"
#include "placing/placed_view.hpp"
#include "placing/places.hpp"
#include "profiles/level_ground.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <utility>

namespace orograph {
namespace {

constexpr std::size_t kSummits = 10;
constexpr int kLeastCells = 16; // along the shorter side
// Smaller ones show no more: a cell of 4 mm, as a sample of 60 x 90 has on A4, is 0.5 mm then.
constexpr double kMostParts = 8;
// A terrain of so many vertices takes a fifth of a second, whatever it shows of them.
constexpr double kMostRefined = 1e6;

// Tells of a vertex whether it is one of water's triangles. REQUIRES that both outlive it.
std::function<bool(int, int)> is_of_water(const TriangleSet& water, const Grid& grid) {
  return [&](int column, int row) {
    const auto has = [&](int c, int r, Half half) {
      return c >= 0 && r >= 0 && c + 1 < grid.columns && r + 1 < grid.rows &&
             water.has(grid_triangle(grid, c, r, half));
    };
    return !water.empty() &&
           (has(column, row, Half::upper) || has(column, row, Half::lower) ||
            has(column - 1, row - 1, Half::upper) || has(column - 1, row - 1, Half::lower) ||
            has(column - 1, row, Half::upper) || has(column, row - 1, Half::lower));
  };
}

// Of the file's cells to one that is drawn, about; less than one where the page shows the file's as
// facets.
double chosen_step(const Grid& grid, const CellSizes& asked, double cell_mm) {
  const double doublings = std::floor(std::log2(asked.least_mm / cell_mm) + 0.5),
               halvings = std::floor(std::log2(cell_mm / asked.most_mm) + 0.5);
  const int smaller_side = std::min(grid.columns, grid.rows);
  double step = 1;
  for (int k = 0; k < doublings && smaller_side / (2 * step) >= kLeastCells; ++k) step *= 2;
  for (int k = 0; k < halvings && 1 / step < kMostParts; ++k) {
    if (4 * static_cast<double>(grid.size()) / (step * step) > kMostRefined) break;
    step /= 2;
  }
  return step;
}

Grid level_of(const Grid& grid, double step, const TriangleSet& water) {
  if (step == 1) return grid;
  if (step < 1) return refined(grid, static_cast<int>(1 / step));
  return generalised(grid, static_cast<int>(step), is_of_water(water, grid));
}

// A level of `grid`, which is `file` or a part of it. Of the file at least `least_of_water`
// vertices make water.
std::shared_ptr<const MadeLevel> made_level(const TerrainData& file, const Grid& grid, double step,
                                            const TriangleSet& water, std::size_t least_of_water) {
  MadeLevel out;
  out.step = step;
  const auto level = std::make_shared<TerrainLevel>();
  level->terrain = file;
  Grid& made = level->terrain.surface.emplace<Grid>(level_of(grid, step, water));
  if (made.is_on_earth()) limit_lean(made);
  out.departure = step < 1 ? departure_of(grid, made) : departure_of(made, grid);
  level->terrain.surface_error_m += out.departure.greatest_m;
  out.summits =
      file.larger_cells ? summits_of(*file.larger_cells, made) : summits_of(grid, made, kSummits);
  level->facts = facts_of(level->terrain);
  const double least = static_cast<double>(least_of_water) / (step * step);
  level->facts.water = find_level_ground(made, static_cast<std::size_t>(std::max(2.0, least)));
  out.level = level;
  return std::make_shared<const MadeLevel>(std::move(out));
}

// How far the highest summits of the page move on it.
void tell_summits(LevelOfDetail& level, const std::vector<Summit>& summits,
                  const PlacedView& placed) {
  for (const Summit& summit : summits) {
    const auto place = [&](Vec3 at) { return placed.on_page(to_profile_frame(placed.view, at)); };
    const Vec3 from = place(summit.of_file_m), to = place(summit.drawn_m);
    if (!is_on_page(placed, from) || !(to.z > 0)) continue;
    ++level.summits;
    const double moved_mm =
        std::hypot(from.x / from.z - to.x / to.z, from.y / from.z - to.y / to.z);
    level.summit_moved_mm = std::max(level.summit_moved_mm, moved_mm);
    level.summits_moved += moved_mm > kSummitMoved_mm ? 1 : 0;
  }
}

// Cells that were read larger than the raster's come on top of what is made of them; departures
// are then bounds, by the sum of both.
void tell_larger_cells(LevelOfDetail& level, const LargerCells& read) {
  level.step *= read.step;
  level.most_step = level.step;
  level.greatest_m += read.departure.greatest_m;
  level.rms_m += read.departure.rms_m;
}

bool all_face_up(const Tin& tin) {
  std::atomic<bool> all = true;
  on_all_cores(tasks_of_triangles(tin), [&](std::size_t task) {
    for (const std::uint32_t t : triangles_of_task(tin, task)) {
      const auto& corners = tin.triangles[t];
      const Vec2 a = plan_m(tin, corners[0]);
      if (!(cross(plan_m(tin, corners[1]) - a, plan_m(tin, corners[2]) - a) > 0)) all = false;
    }
  });
  return all;
}

// Of what is shown: the rest is as coarse as may be.
void tell_patches(LevelOfDetail& level, const Grid& grid, const Patches& patches,
                  const Patchwork& made,
                  const std::function<double(const PatchPlace&)>& mm_per_m_of,
                  double exaggeration) {
  const GridSteps steps = steps_of(grid);
  const double cell_m = std::max(length(steps.column_m), length(steps.row_m));
  int finest = patches.levels().coarsest, coarsest = patches.levels().finest;
  double squares = 0, shown = 0;
  for (std::size_t i = 0; i < made.departures.size(); ++i) {
    const Patch& patch = patches.patches()[i];
    const double mm_per_m = mm_per_m_of(patches.place_of(patch));
    if (!(mm_per_m > 0)) continue;
    finest = std::min(finest, patch.level);
    coarsest = std::max(coarsest, patch.level);
    const Departure& departure = made.departures[i];
    level.greatest_m = std::max(level.greatest_m, departure.greatest_m);
    squares += departure.rms_m * departure.rms_m;
    ++shown;
    if (std::isinf(mm_per_m)) continue; // at the eye's feet
    level.cell_mm = std::max(level.cell_mm, std::ldexp(cell_m, patch.level) * mm_per_m);
    level.greatest_mm = std::max(level.greatest_mm, departure.greatest_m * exaggeration * mm_per_m);
  }
  if (shown > 0) level.rms_m = std::sqrt(squares / shown);
  level.step = std::ldexp(1.0, std::min(finest, coarsest));
  level.most_step = std::ldexp(1.0, coarsest);
  level.cell_m = level.step * cell_m;
}

// Draped lines are laid by a lattice's degrees.
bool needs_lattice(const TerrainData& terrain, const Style& style) {
  return terrain.map.earth && style.asks_for("drape");
}

// Whether the smooth surface through the file's heights, which is rounded where that has a summit,
// may stand in for it: to an eye close above one the rounded top hides what lies below, unless
// cells are small beside the eye's height.
bool stands_high(const Grid& grid, const View& view, double cell_m) {
  constexpr double kCells = 0.25;
  const auto ground = height_at(grid, view.depth_origin_m);
  return ground && view.eye_z_m / view.exaggeration - *ground >= kCells * cell_m;
}

// Whether an eye that is given with its height would be under the ground.
bool buries_eye(const Tin& tin, const View& view) {
  const auto ground = height_at(tin, view.depth_origin_m);
  return ground && *ground * view.exaggeration > view.eye_z_m;
}

// With departures of those patches alone that `mm_per_m` says are shown: of a large raster most
// aren't, and to look at all of it takes 20 ms.
PatchSource measured_where_shown(PatchSource source, const Patches& patches,
                                 std::function<double(const PatchPlace&)> mm_per_m_of) {
  source.departure = [&patches, of_all = std::move(source.departure),
                      mm_per_m_of = std::move(mm_per_m_of)](const Patch& patch,
                                                            const PatchHeights& own) {
    return mm_per_m_of(patches.place_of(patch)) > 0 ? of_all(patch, own) : Departure{};
  };
  return source;
}

// From now on the terrain is made of these patches of a grid, which is so far from the file's.
void take_patchwork(TerrainOfView& terrain, Patchwork made, const Grid& grid, double error_m,
                    bool has_eye) {
  const TerrainData& file = terrain.of_file();
  const auto level = std::make_shared<TerrainLevel>();
  level->terrain = file;
  level->terrain.surface_error_m = error_m;
  Tin& tin = level->terrain.surface.emplace<Tin>(std::move(made.tin));
  const GridSteps steps = steps_of(grid);
  const double least_water_m2 = 0.5 * std::abs(cross(steps.column_m, steps.row_m)) *
                                static_cast<double>(least_of_water(grid));
  level->facts = facts_of(
      tin, [&] { return find_level_ground(tin, made.heights_m, least_water_m2); }, has_eye);
  terrain.take_level(level);
}

// The ground that an eye stands over, in cells as large as the page asks for at each place. None
// where the file's are right everywhere, where it would bury the eye, and where cliffs far away
// lean beyond upright.
std::optional<LevelOfDetail> take_patches(TerrainOfView& terrain, const TerrainFacts& of_file,
                                          const MapSpec& spec, const PlacedView& placed) {
  const TerrainData& file = terrain.of_file();
  const Grid& grid = std::get<Grid>(file.surface);
  const TriangleSet& water = of_file.water.triangles;
  const GroundRanges ranges(grid);
  const ScaleOnPage scale(grid, ranges, placed);
  const int finest = spec.style.detail.cell_mm || stands_high(grid, placed.view, of_file.cell_m)
                         ? kFinestLevel
                         : 0;
  const Patches patches = patches_of_view(grid, scale, asked_size(spec.style), finest);
  if (std::ranges::all_of(patches.patches(), [](const Patch& patch) { return patch.level == 0; }))
    return std::nullopt;
  const auto mm_per_m_of = [&](const PatchPlace& part) { return scale.mm_per_m(part); };
  const PatchSource source = patches_of_grid(grid, patches, is_of_water(water, grid));
  Patchwork made = patchwork(grid, patches, measured_where_shown(source, patches, mm_per_m_of));
  const bool has_height = spec.view.eye_map ? spec.view.eye_map->z.has_value()
                                            : spec.view.eye_lonlat && spec.view.eye_lonlat->z;
  if (made.tin.triangles.empty() || !all_face_up(made.tin) ||
      (has_height && buries_eye(made.tin, placed.view)))
    return std::nullopt;
  LevelOfDetail level;
  tell_patches(level, grid, patches, made, mm_per_m_of, placed.exaggeration);
  tell_summits(level, summits_of(grid, made, patches, kSummits), placed);
  take_patchwork(terrain, std::move(made), grid, file.surface_error_m, true);
  return level;
}

// The same of a raster of which larger cells were read, and its own near the eye. None where these
// weren't, and where cliffs far away lean beyond upright.
std::optional<LevelOfDetail> take_patches_of_raster(TerrainOfView& terrain,
                                                    const TerrainFacts& of_file,
                                                    const MapSpec& spec, const PlacedView& placed) {
  const TerrainData& file = terrain.of_file();
  const Grid& larger = std::get<Grid>(file.surface);
  const TriangleSet& water = of_file.water.triangles;
  const GroundRanges ranges(larger);
  const PatchesOfRaster of(file, ranges, placed, spec);
  if (!of.missing().empty()) return std::nullopt;
  const auto mm_per_m_of = [&](const PatchPlace& part) { return of.mm_per_m(part); };
  const PatchSource source =
      patches_of_raster(larger, *file.larger_cells, of.patches(), is_of_water(water, larger));
  Patchwork made =
      patchwork(larger, of.patches(), measured_where_shown(source, of.patches(), mm_per_m_of));
  if (made.tin.triangles.empty() || !all_face_up(made.tin)) return std::nullopt;
  LevelOfDetail level;
  tell_patches(level, of.raster(), of.patches(), made, mm_per_m_of, placed.exaggeration);
  tell_summits(level, summits_of(*file.larger_cells, of.raster(), made, of.patches()), placed);
  take_patchwork(terrain, std::move(made), larger, 0, true); // departures are from the raster
  return level;
}

LevelOfDetail told_certified(const Grid& grid, const Patches& patches, const Patchwork& made,
                             const HeightOnPage& heights) {
  LevelOfDetail level;
  tell_patches(
      level, grid, patches, made, [&](const PatchPlace& part) { return heights.moves_mm(part, 1); },
      1);
  level.greatest_mm = greatest_error_mm(patches, made.departures, heights) / kFramedAnew;
  return level;
}

// The ground in cells as large as may be while no point of it moves on the page by more than is
// asked, from wherever it is seen. None where that would spare nothing: patches are sewn, and drawn
// as a TIN.
std::optional<LevelOfDetail> take_certified(TerrainOfView& terrain, const MapSpec& spec,
                                            const PlacedView& placed) {
  const TerrainData& file = terrain.of_file();
  const Grid& grid = std::get<Grid>(file.surface);
  const HeightOnPage heights(grid, placed);
  const Patches patches =
      certified_patches(grid, heights, kFramedAnew * *spec.style.detail.error_mm);
  if (!spare_enough(patches, grid.size())) return std::nullopt;
  Patchwork made = patchwork(grid, patches, patches_of_grid(grid, patches, {}));
  if (made.tin.triangles.empty() || !all_face_up(made.tin)) return std::nullopt;
  LevelOfDetail level = told_certified(grid, patches, made, heights);
  tell_summits(level, summits_of(grid, made, patches, kSummits), placed);
  take_patchwork(terrain, std::move(made), grid, file.surface_error_m, spec.view.has_eye());
  return level;
}

// The same of a raster of which larger cells were read, and its own where patches need them.
LevelOfDetail take_certified_of_raster(TerrainOfView& terrain, const MapSpec& spec,
                                       const PlacedView& placed) {
  const TerrainData& file = terrain.of_file();
  const CertifiedRaster of(file, placed, spec);
  Patchwork made;
  if (of.missing().empty())
    made =
        patchwork(std::get<Grid>(file.surface), of.patches(), nested_patches(*file.larger_cells));
  if (made.tin.triangles.empty() || !all_face_up(made.tin))
    throw Error(file.source + " can't be drawn within a bound from here: a part of it is missing",
                "ask for cells of a size with `detail`, or keep a part with `bbox`");
  LevelOfDetail level = told_certified(of.raster(), of.patches(), made, of.heights());
  tell_summits(level, summits_of(*file.larger_cells, of.raster(), made, of.patches()), placed);
  take_patchwork(terrain, std::move(made), of.raster(), 0, spec.view.has_eye());
  return level;
}

} // namespace

std::optional<LevelOfDetail> choose_level(TerrainOfView& terrain, const MapSpec& spec,
                                          const SceneFile* solids) {
  const DetailSpec& detail = spec.style.detail;
  if (detail.of_file || (spec.ground_points && !detail.cell_mm && !detail.error_mm))
    return std::nullopt;
  const TerrainData& file = terrain.of_file();
  const Grid* const whole = std::get_if<Grid>(&file.surface);
  if (!whole || terrain.is_cut()) return std::nullopt;
  TerrainInFrame& in_frame = terrain.in_frame();
  const TerrainFacts& of_file = in_frame.facts();
  if (detail.error_mm) {
    if (needs_lattice(file, spec.style)) return std::nullopt;
    if (file.larger_cells)
      return take_certified_of_raster(terrain, spec, placed_picture(file, of_file, spec, solids));
    return take_certified(terrain, spec, placed_picture(file, of_file, spec, solids));
  }
  if (stands_over_ground(spec.view, file, of_file)) {
    if (file.larger_cells) {
      const auto level = take_patches_of_raster(terrain, of_file, spec,
                                                placed_picture(file, of_file, spec, solids));
      if (level) return level;
      LevelOfDetail as_read;
      as_read.cell_m = of_file.cell_m;
      tell_larger_cells(as_read, *file.larger_cells);
      return as_read;
    }
    // A sheet's underside and a block's walls are the file's, unless a size is asked for.
    const bool has_more_sides =
        spec.style.underside == Underside::draw || spec.style.asks_for("block");
    if (needs_lattice(file, spec.style) || (!detail.cell_mm && has_more_sides)) return std::nullopt;
    return take_patches(terrain, of_file, spec, placed_picture(file, of_file, spec, solids));
  }
  std::optional<TerrainData> land;
  std::optional<TerrainFacts> of_land;
  if (!solids)
    if (const auto part = land_part(*whole, of_file.water.triangles, spec)) {
      land = file;
      Grid& kept = land->surface.emplace<Grid>(part_of_grid(*whole, *part));
      if (kept.is_on_earth()) limit_lean(kept);
      of_land = facts_of(*land);
    }
  const TerrainFacts& facts = of_land ? *of_land : of_file;
  const TerrainData& shown = land ? *land : file;
  const Grid& grid = std::get<Grid>(shown.surface);
  const PlacedView placed = placed_picture(shown, facts, spec, solids);
  const double cell_mm = greatest_cell_mm(placed, grid);
  if (!(cell_mm > 0) || (std::isinf(cell_mm) && !detail.cell_mm)) return std::nullopt;
  LevelOfDetail level;
  const LargerCells* const read = file.larger_cells ? &*file.larger_cells : nullptr;
  level.step = chosen_step(grid, asked_size(spec.style), cell_mm);
  if (read) level.step = std::max(level.step, 1.0); // the raster has smaller ones, which were read
  if (level.step == 1 && !land) {
    if (!read) return std::nullopt;
    level.cell_m = facts.cell_m;
    level.cell_mm = cell_mm;
    tell_larger_cells(level, *read);
    tell_summits(level, summits_of(*read, grid), placed);
    return level;
  }

  // A part of the land is of this view alone.
  std::shared_ptr<const MadeLevel> made = land ? nullptr : in_frame.level_of_step(level.step);
  if (!made) {
    made = made_level(file, grid, level.step, facts.water.triangles, least_of_water(*whole));
    if (!land) in_frame.keep(made);
  }
  level.cell_m = made->level->facts.cell_m;
  level.cell_mm = level.step * cell_mm;
  level.greatest_m = made->departure.greatest_m;
  level.rms_m = made->departure.rms_m;
  level.most_step = level.step;
  if (read) tell_larger_cells(level, *read);
  tell_summits(level, made->summits, placed);
  terrain.take_level(made->level);
  return level;
}

} // namespace orograph
