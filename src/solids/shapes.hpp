// SPDX-License-Identifier: GPL-3.0-or-later
// Building blocks with plane faces, and bodies of turned profiles; in metres of their own frame, z
// upwards.
#pragma once

#include "geometry/angle.hpp"
#include "geometry/vec.hpp"
#include "solids/solid.hpp"

#include <array>
#include <variant>
#include <vector>

namespace orograph {

// Each building block throws Error where it is flat or empty, or an outline is no simple polygon,
// and the Errors of `build_solid`. Outlines have three corners or more, in either direction, and
// need not be convex.

/// Stands on z = 0, its centre above the origin. All three lengths above 0.
Solid box(Vec3 size_m);

/// Stands on its base at z = 0; height above 0.
Solid prism(std::vector<Vec2> base_m, double height_m);

/// A point, or a height above the middle (the mean) of the base's corners.
using Apex = std::variant<Vec3, double>;

/// Stands on its base at z = 0, the apex above it.
Solid pyramid(std::vector<Vec2> base_m, const Apex& apex_m);

/// In either orientation. (Angell and Jones 1983, exercise 9.2a.)
Solid tetrahedron(const std::array<Vec3, 4>& vertices_m);

// Bodies that a profile leaves behind as it turns about the z axis.
// Source: Ian O. Angell and Brian J. Jones, Advanced graphics with the BBC model B microcomputer,
// 1983, listing 9.10 and exercise 9.4; they are wires there, and closed bodies here.

/// How a profile, points (r, z) with r >= 0, turns: counterclockwise from above, in flat steps.
struct Turning {
  std::vector<Vec2> profile_m;
  int sides = 0; ///< steps in a whole turn
  Angle start;   ///< of the first profile, from the x axis
  /// Only the outline of the curved surface is drawn, with caps' edges, and edges along the way
  /// where the profile bends by more than 20 degrees. Otherwise all edges are.
  bool smooth = false;
};

/// Body of revolution. Ends of the profile off the axis are closed by level caps; if its last point
/// is its first it is a ring instead. Points within 1e-12 of the greatest r are on the axis; pieces
/// along the axis leave nothing. Either direction of the profile is fine.
///
/// Throws Error: sides not 3 to 10,000; fewer than two points, r < 0; a profile that crosses or
/// touches itself or a cap, encloses nothing, or needs over a million faces.
Solid revolution(const Turning& turning);

struct Rise {
  double per_turn_m = 0; ///< may be negative
  double turns = 1;      ///< above 0; sides times turns is whole
};

/// Body of rotation: the profile, a closed polygon off the axis, rises while it turns, and its two
/// ends are flat caps. The surface's quadrangles aren't plane; each is two triangles with a smooth
/// edge between. Whether turns run into each other is not looked at, but for rings that close on
/// themselves.
///
/// Throws Error as `revolution`; r <= 0; a count of steps that isn't whole, at least 1; no rise in
/// a whole turn or more.
Solid rotation_body(const Turning& turning, const Rise& rise);

} // namespace orograph
