// SPDX-License-Identifier: GPL-3.0-or-later
// What solids and ground hide of each other: edges of solids that are seen, and what of the lines
// of the terrain is behind solids.
#pragma once

#include "dem/terrain.hpp"
#include "hidden_lines/line_parts.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "horizon/clip_profile.hpp"
#include "placing/placed_view.hpp"
#include "profiles/profile.hpp"
#include "profiles/sheet.hpp"
#include "profiles/sheet_part.hpp"
#include "solids/solids_in_view.hpp"

#include <span>
#include <vector>

namespace orograph {
/// Parts of the edges of all solids, numbered through, by number; along the edge, 0 at `from` and 1
/// at `to`.
struct SolidParts {
  std::vector<LinePart> visible;
  std::vector<LinePart> hidden; ///< in front of the near plane, and not visible
};

/// What hides of a sector's ground: its lines (`lines_of`), as far as they hide, and the segments
/// where the near plane cuts it. Of lines that are drawn only what is visible of them counts, by
/// line: what stands in front of the rest hides all that it would. REQUIRES that all outlive it.
struct HidingGround {
  const TerrainData& terrain;
  const PlacedView& placed;
  const Sector& sector;
  const std::vector<EdgeLine>& lines;
  const std::vector<LinePart>& visible;
  std::span<const Segment> near_cut;
  const Sheet* sheet = nullptr; ///< the ground, where it has two sides: then its triangles hide
  const SheetPart* sheet_part = nullptr;
};

/// Of the edges of solids among each other, and, where there is ground, with what it stands in
/// front of or buries. Faces that are turned away are culled first (Chen and Sabbagh 1983,
/// section 5.8), so an edge between two of them is hidden as a whole, and one between a light and a
/// dark face is there once. Cost: a look at each line of the ground and at each edge, and the
/// shadows that are found.
SolidParts seen_edges(const SolidsInView& solids, const HidingGround* ground);

/// What of them is within a range of X: of a panorama's sector, which knows what hides there alone.
void keep_in_range(SolidParts& parts, std::span<const StandingSolid> standing, const View& view,
                   XRange range);

/// Takes out of the runs of a profile what is behind solids. Cost: a look at each span, and the
/// triangles of solids that are in front of it.
void leave_out_behind(const SolidsInView& solids, const Profile& profile,
                      std::vector<VisibleRun>& runs);

/// The same of parts of lines, by line.
std::vector<LinePart> not_behind(const SolidsInView& solids, const LinePictures& lines,
                                 const std::vector<LinePart>& parts);

} // namespace orograph
