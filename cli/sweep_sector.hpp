// SPDX-License-Identifier: GPL-3.0-or-later
// One sector, front to back: for each depth cut, project, clip against the horizon.
#pragma once

#include "cli/instruments.hpp"
#include "cli/line_sweep.hpp"
#include "cli/render_settings.hpp"
#include "cli/report.hpp"
#include "cli/scene.hpp"
#include "cli/solids/solid_edges.hpp"
#include "dem/terrain.hpp"
#include "draw/stroke_builder.hpp"
#include "profiles/seen_ground.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace orograph {

/// Parts of lines other than profiles, by line.
struct SectorLines {
  std::vector<LinePart> visible; ///< all that is visible, less the following
  std::vector<LinePart> skyline; ///< visible silhouettes that the last horizon is made of
  std::vector<LinePart> folded;  ///< visible silhouettes left out by `--silhouette-jump`
  SolidParts solids;             ///< of edges of solids
};

/// What a sweep adds to.
struct SweepCounts {
  CountsReport& counts;
  SecondsReport& seconds;            ///< facing, cut, project, clip, check and layout only
  std::optional<CheckReport>& check; ///< where the settings ask for it
};

/// What profiles are drawn to.
struct ProfileLayer {
  const StrokeSettings& settings;
  Layer& layer;
  double left_out_mm = 0;          ///< strokes that were too short
  std::size_t dropped_strokes = 0; ///< without length when rounded
};

/// `lines` are those of the scene (`lines_of`), for all of its sectors; `ground` is what the sector
/// looks at, where that isn't all. The visible parts of profiles go to `profiles`, if there is one.
/// `profile_done` is called after each profile.
SectorLines sweep_sector(const Terrain& terrain, const Scene& scene, const Sector& sector,
                         const std::vector<SweptLine>& lines, const SeenGround* ground,
                         const RenderSettings& settings, const Instruments& instruments,
                         ProfileLayer* profiles, const SweepCounts& counts,
                         const std::function<void()>& profile_done);

/// Of a scene without ground.
SectorLines solids_alone(const Scene& scene, const Sector& sector);

} // namespace orograph
