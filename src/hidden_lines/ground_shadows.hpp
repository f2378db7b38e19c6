// SPDX-License-Identifier: GPL-3.0-or-later
// What the ground hides of solids: what it stands in front of, and what of them is buried.
#pragma once

#include "dem/terrain.hpp"
#include "solids/solids_in_view.hpp"

#include <span>
#include <vector>

#include "hidden_lines/line_pass.hpp"
#include "placing/placed_view.hpp"

namespace orograph {

/// A straight piece of ground that stands in front of a solid, or beside it.
struct GroundEdge {
  Vec3 left, right;              ///< profile frame
  double x_begin, x_end, y_high; ///< in the visibility plane
};

struct GroundShadows {
  std::vector<GroundEdge> edges; ///< see `edge_shadow`
  std::vector<Shadow> buried;    ///< by triangles of the ground
  double touching_m = 0;         ///< what is under ground by less lies on it
};

/// For each solid the shadows of ground that may reach it: of the lines that hide (`lines_of`), of
/// the segments where the near plane cuts the ground, and of the triangles about it that bury it.
/// Of lines that are drawn only what is visible of them counts (`visible`, by line): what stands in
/// front of the rest hides all that it would. Cost: a look at each line, and the shadows that are
/// found.
std::vector<GroundShadows> ground_shadows(const TerrainData& terrain, const PlacedView& placed,
                                          const Sector& sector, const std::vector<EdgeLine>& lines,
                                          const std::vector<LinePart>& visible,
                                          std::span<const Segment> near_cut,
                                          const SolidsInView& solids);

} // namespace orograph
