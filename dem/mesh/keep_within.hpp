// SPDX-License-Identifier: GPL-3.0-or-later
// A surface between planes.
#pragma once

#include "dem/mesh/half_space.hpp"
#include "dem/surface.hpp"

#include <span>

namespace orograph {

/// What of the surface lies in all of the half-spaces: a Tin whose border holds the cut lines, and
/// which is cut, hides and is drawn like any other. An empty one where nothing is left.
///  (1) Triangles wholly within stay as they are, with the same numbers for their vertices' places.
///      Vertices and triangles keep their order; the vertices of cut lines come after the others,
///      and the pieces of a triangle take its place. So edges that aren't cut are reckoned alike.
///  (2) A vertex of a cut line is made once for each edge and plane, from the edge's vertex of
///      lower index, and rounded. Planes are taken one after the other; edges that split a piece of
///      an earlier cut count like any. On a border edge the vertex is rounded to the inner side, so
///      that ground which only touches there doesn't overlap.
///  (3) A vertex counts as on a plane where rounding can't tell (half_space.hpp), and where an edge
///      of it that isn't upright meets the plane within 64 roundings of its position seen from
///      above; so slivers go, and what is kept may reach beyond a plane by as much.
///  (4) Planes belong to their half-spaces: a triangle that lies in one is kept. What only touches
///      a plane from beyond, in an edge or a vertex, isn't.
///  (5) Walls are cut into upright pieces between the places, seen from above, where they or walls
///      that share an edge with them meet the plane or have vertices; ground beside them has
///      vertices there too, even where the plane doesn't meet it.
/// The result is valid (verify_tin.hpp), if anything is left. Where triangles are so thin,
/// seen from above (some hundred roundings), that the pieces' rounding turns one over or lays one
/// on another, they are reduced to their upper surface (upper_surface.hpp). Cost O(vertices of the
/// surface + triangles left); memory O(triangles left or cut), and 12 bytes for each vertex of a
/// Tin. (Half of a grid of 2000 x 2000 takes 0.4 s, a tenth of one of 4000 x 4000 0.3 s, with a
/// peak of three times the result's memory.) REQUIRES a Tin that is valid, if not empty.
Tin keep_within(const Surface& surface, std::span<const HalfSpace> spaces);
Tin keep_within(const Grid& grid, std::span<const HalfSpace> spaces);
Tin keep_within(const Tin& tin, std::span<const HalfSpace> spaces);

} // namespace orograph
