// SPDX-License-Identifier: GPL-3.0-or-later
// What of a thin sheet an eye sees, by its definition: a point that no other point of the sheet
// stands in front of, on the upper side or on the underside. Shares no code with the pass.
#pragma once

#include "dem/surface.hpp"
#include "geometry/profile_point.hpp"
#include "reference/ways_over_tin.hpp"
#include "view/view.hpp"

namespace orograph {

class SheetWalk {
public:
  /// REQUIRES that surface and view outlive it. Cost: of a grid the TIN of its triangles.
  SheetWalk(const Surface& surface, const View& view) : ways_(surface), view_(&view) {}
  /// From now on of another view. What is nearer than its near plane stands in front of nothing.
  void set_view(const View& view) { view_ = &view; }

  enum class Sight {
    hidden,
    upper, ///< side of the sheet that is seen
    underside,
    edge,  ///< seen; no ground in front of it meets it
    unsure ///< the way to the eye passes the sheet, or leads along it, within a tolerance
  };
  /// What is this close to a point, seen from above, is at it.
  static constexpr double kAtPoint_m = 1e-7;
  /// Of a point on the sheet, in the view's profile frame. `tolerance_m` is a height. Cost: the
  /// triangles near the way to the eye. REQUIRES a view that isn't straight down or up.
  Sight sight(ProfilePoint point, double tolerance_m) const;

  /// Whether the eye is in the plane of a wall that the point is on, to rounding: it has no width
  /// then. Cost: all walls.
  bool is_on_wall_edge_on(ProfilePoint point) const;

private:
  WaysOverTin ways_;
  const View* view_;
};

} // namespace orograph
