// SPDX-License-Identifier: GPL-3.0-or-later
// A surface's edges as lists, in order.
#pragma once

#include "dem/surface.hpp"
#include "profiles/outline.hpp"
#include "profiles/surface_edge.hpp"
#include "view/view.hpp"

#include <vector>

namespace orograph {

/// All edges of the triangles that are there. Cost: one pass over the triangles.
std::vector<SurfaceEdge> edges_of(const Grid& grid);
std::vector<SurfaceEdge> edges_of(const Tin& tin);
std::vector<SurfaceEdge> edges_of(const Surface& surface);

/// The edges on whose nearer side there is ground, and on whose farther side there is a wall or
/// nothing: what else stands at their place on the ground is behind them. In order.
std::vector<SurfaceEdge> brinks(const Surface& surface, const std::vector<BorderEdge>& border,
                                const View& view);

/// The edges that a wall turned away from the eye hides by itself (profiles/tin_edges.hpp); a grid
/// has none.
std::vector<SurfaceEdge> edges_behind_walls(const Surface& surface, const View& view);

} // namespace orograph
