// SPDX-License-Identifier: GPL-3.0-or-later
// What the ground hides of solids: what it stands in front of, and what of them is buried.
#pragma once

#include "cli/line_sweep.hpp"
#include "cli/scene.hpp"
#include "dem/terrain.hpp"
#include "solids/solids_in_view.hpp"

#include <span>
#include <vector>

namespace orograph {

struct GroundShadow {
  Shadow shadow;
  double x_begin, x_end, y_high; ///< in the visibility plane; all of it lies within and below
};

/// For each solid the shadows of ground that may reach it: of the lines that hide (`lines_of`), of
/// the segments where the near plane cuts the ground, and of the triangles about it that bury it.
/// Of lines that are drawn only what is visible of them counts (`visible`, by line): what stands in
/// front of the rest hides all that it would. Cost: a look at each line, and the shadows that are
/// found.
std::vector<std::vector<GroundShadow>>
ground_shadows(const Terrain& terrain, const Scene& scene, const Sector& sector,
               const std::vector<SweptLine>& lines, const std::vector<LinePart>& visible,
               std::span<const Segment> near_cut, const SolidsInView& solids);

} // namespace orograph
