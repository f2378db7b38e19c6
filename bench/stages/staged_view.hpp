// SPDX-License-Identifier: GPL-3.0-or-later
// One view of a terrain, up to where its first profile is cut.
#pragma once

#include "cli/render_settings.hpp"
#include "cli/scene.hpp"
#include "cli/sector_sweep.hpp"
#include "draw/stroke_builder.hpp"

#include <vector>

namespace orograph {

/// What the stages of drawing begin with, as `draw_scene` makes it. REQUIRES a view with one
/// sector, from beyond the terrain (no near plane cuts it).
class StagedView {
public:
  StagedView(Surface surface, RenderSettings settings);
  StagedView(const StagedView&) = delete;
  StagedView& operator=(const StagedView&) = delete;

  const Sector& sector() const { return scene.sectors.front(); }
  /// Its sector with these lines; they must outlive it.
  SectorInWork work_with(const std::vector<SweptLine>& lines) const;

  const Terrain terrain;
  const RenderSettings settings;
  const Scene scene;
  const SurfaceCutter cutter;
  const TieTolerance tolerance;
  StrokeSettings strokes;
};

} // namespace orograph
