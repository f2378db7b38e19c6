// SPDX-License-Identifier: GPL-3.0-or-later
// The cut of a grid by its definition: every triangle is cut by the plane on its own.
#pragma once

#include "dem/grid.hpp"
#include "profiles/profile.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <string>
#include <vector>

namespace orograph {

struct PlaneVertex {
  long double u, z;
};

/// A triangle's (or, in the plane, an edge's) part of the profile, left to right.
struct CutSegment {
  PlaneVertex left, right;
  bool level;
};

struct TriangleCuts {
  /// Where the plane crosses a column line, a row line or a diagonal, or meets a vertex; sorted by
  /// u. z is NaN where there is no height.
  std::vector<PlaneVertex> vertices;
  std::vector<CutSegment> segments;
};

/// A view along `forward` (unit) with a parallel projection.
View looking(Vec2 forward, Vec2 depth_origin_m = {}, double exaggeration = 1);

/// The vertices' coordinates in the profile frame are rounded, as they have to be, and from there
/// on taken as exact; crossings are reckoned in long double.
TriangleCuts cut_by_triangles(const Grid& grid, const View& view, const TriangleSet& level,
                              double depth_m);

/// A vertex that isn't on the plane and the surface, or out of order, or "".
std::string false_vertex_of(const Profile& profile, const TriangleCuts& expected,
                            double tolerance_m);

/// What is wrong with a profile, or "". Positions are compared within `tolerance_m`.
std::string fault_of(const Profile& profile, const TriangleCuts& expected, double tolerance_m);

/// Total length in u and z of a profile's spans.
double length_of(const Profile& profile);
/// The same of the union of the expected segments.
double length_of(const TriangleCuts& cuts);

} // namespace orograph
