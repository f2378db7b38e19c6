// SPDX-License-Identifier: GPL-3.0-or-later
// What lies in some directions from an eye in the landscape: the terrain cut by upright planes
// through it.
#pragma once

#include "dem/surface.hpp"
#include "geometry/box.hpp"
#include "profiles/cutter_facts.hpp"
#include "profiles/level_ground.hpp"
#include "view/view.hpp"

#include <vector>

namespace orograph {

/// A surface as it is cut.
struct CutSurface {
  const Surface& surface;
  const TriangleSet& level;
  const CutterFacts& for_cutters;
  const Box3* box_m = nullptr; ///< of all vertices, if it is known
};

/// The ground ahead of the eye in the visibility plane's column X = `x`.
struct GroundAhead {
  double x = 0;
  std::vector<double> v_m; ///< depths, rising, from the near plane on
  std::vector<double> z_m; ///< exaggerated, sunk as the view's ground is

  /// Where the column's skyline is, seen from `above_m` above the eye: the greatest Y of all
  /// ground, whether or not something stands in front of it. Index of its point; of no ground, -1.
  std::ptrdiff_t skyline(const View& view, double above_m = 0) const;
  /// Y of a point.
  double y(const View& view, std::size_t i) const { return (z_m[i] - view.eye_z_m) / v_m[i]; }
};

/// For so many columns at even steps over the window, both ends among them, at half its height;
/// those that run aside or behind the eye are left out. `drop` is the view's, north and east.
/// REQUIRES a perspective view and a surface with ground. Cost: a cut each, on all cores.
std::vector<GroundAhead> ground_ahead(const View& view, const EarthDrop& drop, const CutSurface& of,
                                      int columns);

} // namespace orograph
