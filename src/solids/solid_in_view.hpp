// SPDX-License-Identifier: GPL-3.0-or-later
// A standing solid as a view has it: light and dark triangles, and what it hides.
#pragma once

#include "solids/shadow.hpp"
#include "solids/standing_solid.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

/// A box in the visibility plane, and depths. Infinite where something reaches beside the eye.
struct SeenBox {
  double x_begin, x_end, y_low, y_high, nearest_m, farthest_m;
};
/// Of points of the profile frame.
SeenBox seen_box(const View& view, const Vec3* points, std::size_t count);
/// It stands in front of nothing then. What is nearer than the near plane does, though it has no
/// picture.
inline bool is_behind_eye(const View& view, const SeenBox& box) {
  return view.is_perspective() && box.farthest_m <= 0;
}

/// What a light triangle hides.
struct TriangleShadow {
  Shadow shadow;
  SeenBox box;
  std::uint32_t triangle;
};

/// How an edge stands to the eye (Chen and Sabbagh 1983, sections 5.8 and 5.9: light and dark
/// faces).
enum class EdgeFacing : std::uint8_t {
  seen,     ///< between two light triangles, or the outline; or a wire
  dark,     ///< behind its own solid as a whole
  not_drawn ///< smooth, and no outline
};

struct SolidInView {
  const StandingSolid* standing = nullptr;
  std::vector<Vec3> vertices; ///< profile frame
  std::vector<TriangleShadow> shadows;
  std::vector<EdgeFacing> edges;
  SeenBox box{};
  double rounding_m = 0; ///< bound on the rounding of positions
};

/// REQUIRES that the standing solid outlives what comes back. A triangle that is seen edge-on
/// counts as dark.
SolidInView in_view(const StandingSolid& standing, const View& view);

} // namespace orograph
