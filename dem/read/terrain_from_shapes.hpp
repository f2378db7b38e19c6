// SPDX-License-Identifier: GPL-3.0-or-later
// From what files hold to a Terrain.
#pragma once

#include "dem/read/map_shapes.hpp"
#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"

#include <optional>

namespace orograph {

/// The Tin of the triangles, with the ground frame's origin at the north-west corner of the box of
/// their vertices. Of `options`, `bbox` keeps the triangles with all three vertices inside it and
/// `repair` is handed on. Throws Error where nothing is left, a place is none on earth, or the
/// triangles aren't a terrain.
Terrain terrain_from_triangles(MapShapes shapes, const ReadOptions& options);

/// The Tin of the triangulation of `points` with its own lines, those of `lines` and the rings of
/// `boundary`. Where one of the files has no CRS, that of the others is taken, with a note. Of
/// `options`, `bbox` keeps the points inside it, lines between them included, and `max_edge_m` is
/// handed on. Throws Error where the CRSs differ, and as above.
Terrain terrain_from_points(MapShapes points, std::optional<MapShapes> lines,
                            std::optional<MapShapes> boundary, const ReadOptions& options);

} // namespace orograph
