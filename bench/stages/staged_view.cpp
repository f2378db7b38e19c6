// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/stages/staged_view.hpp"

#include "cli/strips.hpp"
#include "cli/tie_tolerance.hpp"

#include <limits>
#include <utility>

namespace orograph {
namespace {

Terrain terrain_of(Surface surface) {
  Terrain terrain;
  terrain.surface = std::move(surface);
  return terrain;
}

} // namespace

StagedView::StagedView(Surface surface, RenderSettings s)
    : terrain(terrain_of(std::move(surface))), settings(std::move(s)),
      scene(place_scene(terrain, settings)),
      cutter(terrain.surface, sector().view, scene.level.triangles, scene.border),
      tolerance(tie_tolerance(sector(), settings.visibility_tolerance_mm)) {
  strokes.to_page = scene.to_page;
  strokes.frame_mm = scene.frame_mm;
  strokes.depth = scene.depth;
  strokes.simplify_mm = settings.simplify_mm;
  strokes.min_stroke_mm = settings.min_stroke_mm;
}

SectorInWork StagedView::work_with(const std::vector<SweptLine>& lines) const {
  const View& view = sector().view;
  return {terrain,
          scene,
          sector(),
          lines,
          cutter,
          tolerance,
          view.is_perspective() ? view.near_m : -std::numeric_limits<double>::infinity(),
          page_range(sector()),
          false,
          nullptr, // all ground
          kVerticesAStrip};
}

} // namespace orograph
