// SPDX-License-Identifier: GPL-3.0-or-later
// One sector, front to back: for each depth cut, project, clip against the horizon.
#pragma once

#include "dem/terrain.hpp"
#include "draw/stroke_builder.hpp"
#include "hidden_lines/contour_chains.hpp"
#include "hidden_lines/counts.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "hidden_lines/hidden_parts.hpp"
#include "hidden_lines/instruments.hpp"
#include "hidden_lines/line_pass.hpp"
#include "hidden_lines/lines_of_view.hpp"
#include "hidden_lines/solid_lines.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"
#include "profiles/seen_ground.hpp"
#include "profiles/silhouettes.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace orograph {

/// Parts of lines other than profiles, by line.
struct SectorLines {
  std::vector<EdgeLine> found;   ///< lines that the pass has found, behind those of the list
  std::vector<LinePart> visible; ///< all that is visible, less skyline and folds
  /// By number among the lines on the ground: 1 for those that are visible from end to end, of
  /// which there is no part. Empty if each visible line is a part.
  std::vector<std::uint8_t> whole_on_ground;
  std::vector<LinePart> skyline; ///< visible silhouettes that the last horizon is made of
  std::vector<LinePart> hidden;  ///< as `hidden_parts`, of kinds that are asked for; less folds
  double folded_mm = 0;  ///< length of visible silhouettes left out by `Style::silhouette_jump`
  SolidParts solids;     ///< of edges of solids
  SeenContours contours; ///< of the levels that the pass was told
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
  Layer* hidden = nullptr;         ///< gets what isn't visible of them, not rounded
  Layer* underside = nullptr;      ///< gets what shows the surface's underside, not rounded
  double left_out_mm = 0;          ///< strokes that were too short
  std::size_t dropped_strokes = 0; ///< without length when rounded
};

/// `ground` is what the sector looks at, where that isn't all. The visible parts of profiles go to
/// `profiles`, if there is one. `profile_done` is called after each profile.
SectorLines sector_pass(const TerrainData& terrain, const PlacedView& placed, const Sector& sector,
                        const LinesOfView& lines, const SeenGround* ground, const Style& style,
                        const Instruments& instruments, ProfileLayer* profiles,
                        const PassCounts& counts, const std::function<void()>& profile_done);

/// The same where there are solids and no ground.
SectorLines solids_alone(const PlacedView& placed, const Sector& sector);

} // namespace orograph
