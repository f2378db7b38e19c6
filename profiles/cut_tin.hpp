// SPDX-License-Identifier: GPL-3.0-or-later
// The exact cut of a TIN by planes of constant depth.
#pragma once

#include "dem/tin.hpp"
#include "profiles/border_sides.hpp"
#include "profiles/profile.hpp"
#include "profiles/tin_mesh.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <span>

namespace orograph {

/// Cuts one TIN for one view, plane after plane, in any order; the profile is that of `GridCutter`,
/// but that there are no vertices where there is no terrain.
///
///  (1) There is a vertex wherever the plane crosses an edge, in order from left to right, once; a
///      plane through a TIN's vertex has that vertex.
///  (2) Between two vertices the profile lies in one triangle, or there is a gap. An edge that lies
///      in the plane is there, and level if either of its triangles is.
///  (3) A crossing is reckoned from its edge's vertex of lower index, exact at both ends.
///  (4) A wall is crossed straight up or down; where it is turned away from the eye there is a gap.
///      A wall that lies in the plane isn't crossed: the profile keeps to its foot or its top,
///      whichever the ground in front of it has.
/// Cost a plane: O(segments + border edges of about its depth).
class TinCutter {
public:
  /// REQUIRES that `tin` and `level` (the triangles whose spans are marked level; may be empty)
  /// outlive the cutter. Cost O(triangles).
  TinCutter(const Tin& tin, const View& view, const TriangleSet& level);

  void cut(double depth_m, Profile& out) const;
  /// All of it, whatever the range.
  void cut(double depth_m, std::span<const URange>, Profile& out) const { cut(depth_m, out); }

  /// Depths between which the TIN lies.
  double nearest_m() const { return nearest_m_; }
  double farthest_m() const { return farthest_m_; }

private:
  const Tin& tin_;
  View view_;
  const TriangleSet& level_;
  double nearest_m_, farthest_m_;
  TriangleSet walls_, turned_walls_;
  BorderSides<TinSide> border_;
};

} // namespace orograph
