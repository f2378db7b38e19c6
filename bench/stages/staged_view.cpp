// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/stages/staged_view.hpp"

#include "hidden_lines/strips.hpp"
#include "placing/sector.hpp"

#include <limits>
#include <utility>

namespace orograph {
namespace {

TerrainData terrain_of(Surface surface) {
  TerrainData terrain;
  terrain.surface = std::move(surface);
  return terrain;
}

// Stages are timed with whole profiles.
MapSpec without_tone(MapSpec spec) {
  spec.style.spread = Spread::planes;
  spec.style.light.reset();
  return spec;
}

} // namespace

StagedView::StagedView(Surface surface, MapSpec s)
    : terrain(terrain_of(std::move(surface))), spec(without_tone(std::move(s))),
      scene(placed_view(terrain, spec)),
      cutter(terrain.surface, sector().view, scene.level.triangles, scene.for_cutters),
      tolerance(tie_tolerance(sector(), spec.style.visibility_tolerance_mm)) {
  strokes.to_page = scene.to_page;
  strokes.frame_mm = scene.frame_mm;
  strokes.depth = scene.depth;
  strokes.simplify_mm = spec.style.simplify_mm;
  strokes.min_stroke_mm = spec.style.min_stroke_mm.value_or(kCrumb_mm);
}

SectorInWork StagedView::work_with(const std::vector<EdgeLine>& lines) const {
  const View& view = sector().view;
  return {terrain,
          scene,
          sector(),
          lines,
          on_ground,
          cutter,
          tolerance,
          view.is_perspective() ? view.near_m : -std::numeric_limits<double>::infinity(),
          page_range(sector()),
          false,
          nullptr, // all ground
          kVerticesAStrip};
}

} // namespace orograph
