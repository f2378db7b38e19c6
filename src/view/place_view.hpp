// SPDX-License-Identifier: GPL-3.0-or-later
// From what a user asks to a view that shows this terrain.
#pragma once

#include "geometry/blocked_points.hpp"
#include "view/view.hpp"

#include <span>

namespace orograph {

/// A straight piece of the terrain's outline, ground frame, true heights, with the terrain on its
/// left seen from above.
struct OutlineEdge {
  Vec3 from, to;
};

/// What a view has to know of a terrain (ground frame, true heights).
struct TerrainShape {
  const BlockedPoints& points;          ///< all its vertices
  std::span<const OutlineEdge> outline; ///< where it begins and ends, holes included
  Box3 box;
  double mean_height_m;
  double cell_m;             ///< finest ground detail
  BlockedPoints beside = {}; ///< other points that have to be shown: vertices of solids
};

/// Places the eye and the window. A window that frames the terrain is its picture's exact bounding
/// box, but for ground that can't be seen: nothing visible is lower than the terrain's near edge.
/// A window given by a field of view is as high as `aspect` (height over width) says.
///
/// Throws Error: a framing perspective would need ground behind the picture plane; eye and target
/// coincide; a parallel view looks up; all terrain is behind the eye.
View place_view(const ViewRequest& request, const TerrainShape& terrain, double aspect);

/// A perspective view of the eye that looks level, in the request's direction; without a window.
/// REQUIRES an eye and a direction.
View level_view(const ViewRequest& request, double cell_m);

} // namespace orograph
