// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of triangles from straight above.
#pragma once

#include "dem/tin.hpp"

#include <cstddef>

namespace orograph {

struct UpperSurface {
  Tin tin;                       ///< valid, or without triangles; vertices without one may be left
  std::size_t hidden = 0;        ///< triangles that were dropped because nothing of them is seen
  std::size_t cut = 0;           ///< triangles of which parts are left
  std::size_t dropped_walls = 0; ///< vertical triangles that fit nothing any more
};

/// Reduces triangles that overlap, seen from above, to the highest at each place. Of two at one
/// height the one of lower number counts.
///  (1) A triangle that overlaps none other stays as it is, bit for bit, and so does one that hides
///      the whole of all that it overlaps; except for new points on edges whose other triangle was
///      cut there. Vertices keep their numbers, new ones follow; pieces take their triangle's
///      place.
///  (2) Parts are bounded by the edges of higher triangles and by the lines where triangles pierce
///      each other. Points where such lines cross are rounded to doubles, and lines bend to go
///      through them, and through points that they pass within 2^-46 of the largest coordinate; so
///      slivers go. The bent lines make a triangulation that is exactly valid, whatever the
///      rounding did. Heights of new points are those of the triangle (along an edge: of the edge),
///      rounded; ones that differ by less than 2^-40 of the largest coordinate are one vertex.
///  (3) Where the surface jumps, both sides end in a border; no walls are added. Walls stay where
///      they still fit: not where an edge that isn't upright has lost what was beside it, nor where
///      an edge has more than two triangles or two run the same way.
///  (4) A triangle of which less than a 1e-11th shows may count as hidden.
/// Cost O(n log n) where few triangles overlap; two sheets of 180,000 triangles each that pierce
/// each other all over take about a minute. REQUIRES finite coordinates, below 1e100; triangles
/// with an area in space, counterclockwise or walls.
UpperSurface upper_surface(const Tin& soup);

} // namespace orograph
