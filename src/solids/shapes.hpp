// SPDX-License-Identifier: GPL-3.0-or-later
// Building blocks with plane faces, in metres of their own frame, z up.
#pragma once

#include "solids/solid.hpp"

#include <array>
#include <variant>
#include <vector>

namespace orograph {

// Each throws Error where the shape is flat or empty, or an outline is no simple polygon, and the
// Errors of `build_solid`. Outlines have three corners or more, in either direction, and need not
// be convex.

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

} // namespace orograph
