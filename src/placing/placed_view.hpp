// SPDX-License-Identifier: GPL-3.0-or-later
// A terrain with a view, a page and a plan: all that is decided before the first cut.
#pragma once

#include "dem/extent.hpp"
#include "dem/overlay.hpp"
#include "dem/terrain.hpp"
#include "draw/shade_strokes.hpp"
#include "draw/stroke_builder.hpp"
#include "placing/choose_view.hpp"
#include "placing/map_spec.hpp"
#include "placing/near_skyline.hpp"
#include "placing/panorama.hpp"
#include "placing/sector.hpp"
#include "placing/terrain_facts.hpp"
#include "placing/terrain_of_view.hpp"
#include "profiles/cutter_facts.hpp"
#include "profiles/level_ground.hpp"
#include "profiles/outline.hpp"
#include "solids/scene_file.hpp"
#include "solids/standing_solid.hpp"
#include "view/view.hpp"

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// The earth's curvature: whether it is drawn, and what it moves.
struct EarthCurvature {
  bool applied = false;
  bool on_ellipsoid = false; ///< of a terrain in degrees; what else might be moved is refraction
  double would_move_mm = 0;  ///< on the page, at most; less refraction
  double refraction = 0;     ///< K; 0 in a parallel view, which has no eye
  CurvatureRadii radii;
};

struct PlacedView {
  SurfaceExtent extent;
  std::vector<BorderEdge> border;
  CutterFacts for_cutters;
  std::vector<StandingSolid> solids;
  LevelGround level;
  View view; ///< of a panorama: that to its middle
  std::optional<Panorama> panorama;
  bool framed_by_skyline = false; ///< looks level, its window shifted (placing/frame_eye_view.hpp)
  std::optional<ChosenView> chosen_view; ///< where the spec leaves it to us
  std::optional<NearSkyline> near_skyline;
  Page page;
  Homography to_page;               ///< visibility plane to page mm; of a panorama near its middle
  Box2 frame_mm;                    ///< strokes end here
  Box2 room_mm;                     ///< of the picture: furniture stands around it
  std::optional<VolumeDepth> depth; ///< and at the front and back plane, where there are any
  EarthCurvature curvature;
  PlanRequest plan;
  std::vector<double> depths_m;         ///< of all profiles, rising; in `view`
  double nearest_m = 0, farthest_m = 0; ///< depths between which there is terrain
  std::vector<Sector> sectors;          ///< ahead, then behind, or a panorama's; at least one
  double cell_m = 0;                    ///< the terrain's finest ground detail
  double reach_m = 0;                   ///< of vertices from the ground frame's origin: a bound
  double exaggeration = 1; ///< of all heights; `view` still has to do it except on the ellipsoid
  bool exaggeration_chosen = false;     ///< by us, not by the user
  std::span<const Overlay> overlays;    ///< to be laid on the ground
  std::optional<double> block_base_m;   ///< height that the block's walls go down to, if it is one
  const Overlay* names = nullptr;       ///< points with names to be put on the page
  const TerrainData* file = nullptr;    ///< of a terrain in patches, in its frame: has all summits
  std::optional<LineShade> ridge_shade; ///< none: light doesn't show in lines' widths

  /// The page's place of a point of `view`'s profile frame, over its last coordinate; a panorama's
  /// before it is cut into strips. Above 0 where there is one.
  Vec3 on_page(ProfilePoint at) const {
    if (!panorama) return to_page.of(project_homogeneous(view, at));
    const Vec2 mm = panorama->page(at);
    return {mm.x, mm.y, std::isfinite(mm.y) ? 1.0 : 0.0};
  }
  /// Length on the page of a small step from a point of the frame, over the step's.
  double mm_per_step(ProfilePoint at, Vec3 step) const {
    if (panorama) return panorama->page.mm_per_step(at, step);
    const Vec3 here = project_homogeneous(view, at);
    return to_page.mm_per_step(
        here, project_homogeneous(view, {at.u + step.x, at.v + step.y, at.z + step.z}) - here);
  }
};

/// REQUIRES that the terrain, and the solids, outlive the placed view. Solids stand on `uncut`,
/// where `terrain` was cut by the view's planes. Throws Error as `place_eye`, `place_view`,
/// `stand_solids`, `leave_out_cut` and `plan_depths` do, and where the eye is under the ground or
/// inside of a solid.
PlacedView placed_view(const TerrainData& terrain, const MapSpec& spec,
                       const SceneFile* solids = nullptr, const TerrainData* uncut = nullptr);

/// The same of a terrain as the view needs it.
PlacedView placed_view(const TerrainOfView& terrain, const MapSpec& spec,
                       const SceneFile* solids = nullptr);

/// Its eye, page and curvature, without sectors, profiles and tone: most of the cost is theirs.
PlacedView placed_picture(const TerrainData& terrain, const TerrainFacts& facts,
                          const MapSpec& spec, const SceneFile* solids);

} // namespace orograph
