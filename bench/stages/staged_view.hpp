// SPDX-License-Identifier: GPL-3.0-or-later
// One view of a terrain, up to where its first profile is cut.
#pragma once

#include "draw/stroke_builder.hpp"
#include "hidden_lines/sector_in_work.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

#include <vector>

namespace orograph {

/// What the stages of drawing begin with, as `draw_map` makes it. REQUIRES a view with one
/// sector, from beyond the terrain (no near plane cuts it).
class StagedView {
public:
  StagedView(Surface surface, MapSpec spec);
  StagedView(const StagedView&) = delete;
  StagedView& operator=(const StagedView&) = delete;

  const Sector& sector() const { return scene.sectors.front(); }
  /// Its sector with these lines; they must outlive it.
  SectorInWork work_with(const std::vector<EdgeLine>& lines) const;

  const TerrainData terrain;
  const MapSpec spec;
  const PlacedView scene;
  const SurfaceCutter cutter;
  const TieTolerance tolerance;
  StrokeSettings strokes;
  const GroundLines on_ground; ///< none
};

} // namespace orograph
