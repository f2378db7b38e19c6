// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on the ground: contours, a mesh, waterlines and others, in straight pieces of which each
// lies in one triangle of the surface. They are seen or hidden as profiles are, and hide nothing.
#pragma once

#include "dem/terrain.hpp"
#include "draw/drawing.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"
#include "profiles/seen_ground.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace orograph {

struct GroundLine {
  SurfaceEdge ends; ///< numbers of vertices, and from the surface's count of them on of points
  std::uint32_t triangle; ///< or, on a wall, the number of its edge in the view's border
  std::uint32_t feature;  ///< number
};

/// What lines are part of: a contour's level, a meridian, a road.
struct GroundFeature {
  LineKind kind;
  Attributes attributes;
  bool is_tick = false; ///< of short lines, which are no crumbs
  double width_mm = 0;  ///< of its lines; 0: the layer's pen
};

/// A line that is an edge of the view's border, turned or not.
struct RimLine {
  std::uint32_t line, border_edge; ///< numbers
  bool is_turned;
};

struct GroundLines {
  std::vector<ProfilePoint> points; ///< in the view's profile frame
  std::vector<GroundLine> lines;
  std::vector<GroundFeature> features;
  bool overlays_are_lifted = false; ///< higher than the ground, which hides none of them by itself
  std::vector<RimLine> rims;        ///< of voids, of a block
  std::size_t first_contour = 0;    ///< feature, of the lowest level
  std::vector<double> levels_to_find_m; ///< of contours, where they aren't among the lines
  std::size_t draped_in_part = 0, not_draped = 0; ///< of overlays' features, as in Counts
  /// Of the overlays' features some may be left for later: the number of tasks of `add_overlays`
  /// that were taken.
  std::optional<std::size_t> overlays_done = {};
};

/// All that a style asks for; contours are left to be found, unless they are to be listed.
/// `ground`: what is looked at, where that isn't all. `most_draped`: as `add_overlays` has it.
/// Throws Error as `contour_levels`, `mesh_lines`, `graticule_lines` and `map_grid_lines` do.
GroundLines ground_lines_of(const TerrainData& terrain, const PlacedView& placed,
                            const Style& style, const SeenGround* ground = nullptr,
                            bool lists_contours = true,
                            std::size_t most_draped = std::numeric_limits<std::size_t>::max());

/// Adds the overlays of the placed view, a feature for each of theirs that is on the ground; points
/// are crosses of `kMark_mm` on the page. Features are taken in order, task by task, from task
/// number `first` on; about `most` lines are enough, and then `overlays_done` tells that there are
/// more. Throws Error where the terrain is on the earth and cut by the view's planes.
constexpr double kMark_mm = 1.4;
void add_overlays(const TerrainData& terrain, const PlacedView& placed, double above_m,
                  GroundLines& out, std::size_t first = 0,
                  std::size_t most = std::numeric_limits<std::size_t>::max());

/// Adds hachures, a feature for each part of one width, with its mean slope in degrees.
void add_hachures(const TerrainData& terrain, const PlacedView& placed, const Style& style,
                  GroundLines& out);

/// Adds what is drawn of a block's walls that are turned to the eye: their foot and corners, and
/// the rims of voids that have no layer; hatching; the contours' heights.
/// `ground`: what is looked at, where that isn't all; other walls have no lines then.
void add_block(const TerrainData& terrain, const PlacedView& placed, const Style& style,
               const SeenGround* ground, GroundLines& out);

/// Of what lies on the ground to the right of a point, which has a picture.
double mm_a_metre_at(const PlacedView& placed, ProfilePoint at);

/// Adds them to a list of lines, in their order.
void append_to(std::vector<EdgeLine>& lines, const GroundLines& on_ground);

} // namespace orograph
