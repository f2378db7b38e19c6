// SPDX-License-Identifier: GPL-3.0-or-later
// The height of the terrain at a ground point.
#pragma once

#include "dem/surface.hpp"

#include <functional>
#include <optional>

namespace orograph {

/// Height in metres on a triangle that holds the point (ground frame, metres), its edges included;
/// none outside of the grid and where no such triangle is there. Exact at vertices: a point within
/// 1e-9 of a cell of a column or row line counts as on it. On the ellipsoid the height is the
/// ground frame's z, exaggerated; where cliffs lean over each other, that of one of the triangles.
std::optional<double> height_at(const Grid& grid, Vec2 ground_m);
/// The same to a rounding, found sooner on the ellipsoid with a place of the ground nearby.
std::optional<double> height_at(const Grid& grid, Vec2 ground_m, Vec3 nearby_m);
/// The same of other heights over the grid's places, by column and row; NaN where there is none.
/// REQUIRES a grid on a map plane.
std::optional<double> height_at(const Grid& grid, Vec2 ground_m,
                                const std::function<double(int, int)>& height_m);
/// The highest where a wall stands. Cost: one pass over the triangles, on all cores.
std::optional<double> height_at(const Tin& tin, Vec2 ground_m);
std::optional<double> height_at(const Surface& surface, Vec2 ground_m);

} // namespace orograph
