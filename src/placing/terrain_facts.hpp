// SPDX-License-Identifier: GPL-3.0-or-later
// What placing has to know of a terrain, whatever the view.
#pragma once

#include "dem/extent.hpp"
#include "dem/terrain.hpp"
#include "geometry/box.hpp"
#include "placing/map_spec.hpp"
#include "profiles/cutter_facts.hpp"
#include "profiles/level_ground.hpp"
#include "profiles/outline.hpp"

#include <functional>
#include <vector>

namespace orograph {
/// Found once, they do for all views of the same terrain. Most of what placing costs.
struct TerrainFacts {
  SurfaceExtent extent;
  double cell_m = 0;  ///< the terrain's finest ground detail
  double reach_m = 0; ///< of its vertices from the ground frame's origin: a bound
  std::vector<BorderEdge> border;
  CutterFacts for_cutters;
  std::vector<OutlineEdge> outline; ///< the border on the ground
  LevelGround water;                ///< empty where there is none
};

/// REQUIRES that the terrain outlives the facts, and stays where it is. Cost: two passes over the
/// heights, a third where some are missing.
TerrainFacts facts_of(const TerrainData& terrain);
/// The same of a TIN whose level ground is found in another way. `with_index`: what parts of its
/// profiles need as well, which an eye sees. Cost: some passes over the triangles, on all cores.
TerrainFacts facts_of(const Tin& tin, const std::function<LevelGround()>& find_level,
                      bool with_index);

/// The edges of its border, voids' borders too: `border_edges` of either kind. Cost: one pass.
std::vector<BorderEdge> border_of(const Surface& surface);

/// 1, 1.5 or 2, so that most terrains read well from 25 degrees: by highest less lowest height over
/// the longer side of the ground. Steep terrain, from 0.12 on, is left true; 0.06 is a high
/// mountain range of 30 km.
double chosen_exaggeration(const Box3& terrain);

/// What heights are multiplied by: as the view says, or chosen; 1 from a given eye, which sees
/// the world as it is, and where there is no terrain (an empty box).
double exaggeration_of(const ViewSpec& view, const Box3& terrain);

/// Box of all vertices in the terrain's own coordinates.
Box2 map_bounds(const TerrainData& terrain);

} // namespace orograph
