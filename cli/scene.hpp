// SPDX-License-Identifier: GPL-3.0-or-later
// A terrain with a view, a page and a plan: all that is decided before the first cut.
#pragma once

#include "cli/render_settings.hpp"
#include "dem/extent.hpp"
#include "dem/terrain.hpp"
#include "draw/stroke_builder.hpp"
#include "profiles/level_ground.hpp"
#include "profiles/outline.hpp"
#include "solids/standing_solid.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace orograph {

/// A depth to cut at, in its sector, and the profile's number in the drawing.
struct PlannedProfile {
  double depth_m;
  std::int32_t number;
};

/// What is ahead of the eye, or, where the page shows any of that, behind it.
struct Sector {
  View view;
  Homography to_page;                   ///< its visibility plane to page mm
  std::vector<PlannedProfile> profiles; ///< front to back
  double nearest_m = 0, farthest_m = 0; ///< depths between which there is terrain
  bool behind = false;
  bool keeps_strip = false; ///< has a sector behind it, and what lies between the two
};

/// The earth's curvature: whether it is drawn, and what it moves.
struct SceneCurvature {
  bool applied = false;
  bool on_ellipsoid = false; ///< of a terrain in degrees; what else might be moved is refraction
  double would_move_mm = 0;  ///< on the page, at most; less refraction
  double refraction = 0;     ///< K; 0 in a parallel view, which has no eye
  CurvatureRadii radii;
};

struct Scene {
  SurfaceExtent extent;
  std::vector<BorderEdge> border;
  std::vector<StandingSolid> solids;
  LevelGround level; ///< empty where level ground is drawn like any other
  View view;
  Page page;
  Homography to_page;               ///< visibility plane to page mm
  Box2 frame_mm;                    ///< strokes end here
  std::optional<VolumeDepth> depth; ///< and at the front and back plane, where there are any
  SceneCurvature curvature;
  PlanRequest plan;
  std::vector<double> depths_m;         ///< of all profiles, rising; in `view`
  double nearest_m = 0, farthest_m = 0; ///< depths between which there is terrain
  std::vector<Sector> sectors;          ///< ahead, then behind; at least one
  double cell_m = 0;                    ///< the terrain's finest ground detail
  double exaggeration = 1; ///< of all heights; `view` still has to do it except on the ellipsoid
  bool exaggeration_chosen = false; ///< by us, not by the user
};

/// 1, 1.5 or 2, so that most terrains read well from 25 degrees: by highest less lowest height over
/// the longer side of the ground. Steep terrain, from 0.12 on, is left true; 0.06 is a high
/// mountain range of 30 km.
double chosen_exaggeration(const Box3& terrain);

/// What heights are multiplied by: as the settings say, or chosen; 1 from a given eye, which sees
/// the world as it is, and where there is no terrain (an empty box).
double exaggeration_of(const RenderSettings& settings, const Box3& terrain);

/// What placing has to know of a terrain, whatever the view: found once, it does for all views of
/// the same terrain. Most of what placing costs.
struct TerrainFacts {
  SurfaceExtent extent;
  double cell_m = 0; ///< the terrain's finest ground detail
  std::vector<BorderEdge> border;
  std::vector<OutlineEdge> outline; ///< the border on the ground
  LevelGround water;                ///< empty where it is drawn like any other ground
};

/// REQUIRES that the terrain outlives the facts, and stays where it is. Cost: two passes over the
/// heights, a third where some are missing.
TerrainFacts facts_of(const Terrain& terrain, FlatGround flat);

/// REQUIRES that the terrain, and the settings' solids, outlive the scene; `facts` are those of
/// this terrain, for `settings.flat`. Solids stand on `uncut`, where `terrain` was cut by the
/// view's planes. Throws Error as `place_eye`, `place_view`, `stand_solids`, `leave_out_cut` and
/// `plan_depths` do, and where the eye is under the ground or inside of a solid.
Scene place_scene(const Terrain& terrain, const RenderSettings& settings,
                  const Terrain* uncut = nullptr);
Scene place_scene(const Terrain& terrain, TerrainFacts facts, const RenderSettings& settings,
                  const Terrain* uncut = nullptr);

} // namespace orograph
