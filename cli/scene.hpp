// SPDX-License-Identifier: GPL-3.0-or-later
// A terrain with a view, a page and a plan: all that is decided before the first cut.
#pragma once

#include "cli/render_settings.hpp"
#include "dem/extent.hpp"
#include "dem/terrain.hpp"
#include "profiles/level_ground.hpp"
#include "profiles/outline.hpp"
#include "view/view.hpp"

#include <vector>

namespace orograph {

struct Scene {
  SurfaceExtent extent;
  std::vector<BorderEdge> border;
  LevelGround level; ///< empty where level ground is drawn like any other
  View view;
  Page page;
  Homography to_page; ///< visibility plane to page mm
  PlanRequest plan;
  std::vector<double> depths_m;
  double nearest_m = 0, farthest_m = 0; ///< depths between which there is terrain
  double cell_m = 0;                    ///< its finest ground detail
  bool exaggeration_chosen = false;     ///< by us, not by the user
};

/// 1, 1.5 or 2, so that most terrains read well from 25 degrees: by highest less lowest height over
/// the longer side of the ground. Steep terrain, from 0.12 on, is left true; 0.06 is a high
/// mountain range of 30 km.
double chosen_exaggeration(const Box3& terrain);

/// REQUIRES that the terrain outlives the scene. Throws Error as `place_view` and `plan_depths` do,
/// and where the eye is under the ground.
Scene place_scene(const Terrain& terrain, const RenderSettings& settings);

} // namespace orograph
