// SPDX-License-Identifier: GPL-3.0-or-later
// One sector, front to back: for each depth cut, project, clip against the horizon.
#pragma once

#include "dem/terrain.hpp"
#include "draw/stroke_builder.hpp"
#include "hidden_lines/counts.hpp"
#include "hidden_lines/instruments.hpp"
#include "hidden_lines/line_pass.hpp"
#include "hidden_lines/solid_lines.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"
#include "profiles/seen_ground.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace orograph {

/// Parts of lines other than profiles, by line.
struct SectorLines {
  std::vector<LinePart> visible; ///< all that is visible, less the following
  std::vector<LinePart> skyline; ///< visible silhouettes that the last horizon is made of
  std::vector<LinePart> folded;  ///< visible silhouettes left out by `Style::silhouette_jump`
  SolidParts solids;             ///< of edges of solids
};

/// What a pass adds to.
struct PassCounts {
  Counts& counts;
  StageSeconds& seconds; ///< facing, cut, project, clip, check and layout only
};

/// What profiles are drawn to.
struct ProfileLayer {
  const StrokeSettings& settings;
  Layer& layer;
  double left_out_mm = 0;          ///< strokes that were too short
  std::size_t dropped_strokes = 0; ///< without length when rounded
};

/// `lines` are those of the placed view (`lines_of`), for all of its sectors; `ground` is what the
/// sector looks at, where that isn't all. The visible parts of profiles go to `profiles`, if there
/// is one. `profile_done` is called after each profile.
SectorLines sector_pass(const TerrainData& terrain, const PlacedView& placed, const Sector& sector,
                        const std::vector<EdgeLine>& lines, const SeenGround* ground,
                        const Style& style, const Instruments& instruments, ProfileLayer* profiles,
                        const PassCounts& counts, const std::function<void()>& profile_done);

/// The same where there are solids and no ground.
SectorLines solids_alone(const PlacedView& placed, const Sector& sector);

} // namespace orograph
