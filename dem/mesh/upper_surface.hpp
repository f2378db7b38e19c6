// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of triangles from straight above.
#pragma once

#include "dem/mesh/neighbours.hpp"
#include "dem/mesh/overlap.hpp"
#include "dem/tin.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

/// A part of a triangle that is seen.
struct UpperPiece {
  std::uint32_t of = 0; ///< the triangle that it is part of
  std::array<std::uint32_t, 3> triangle;
};

struct UpperPieces {
  std::vector<Vec3> vertices_m;   ///< the Tin's, and new ones after them
  std::vector<UpperPiece> pieces; ///< by `of`; a triangle that stays whole is its own piece
  std::vector<PlanEdge> split;    ///< edges of chosen triangles that got points, in order
};

/// The step of `upper_surface` that cuts overlapping triangles where one comes out from under
/// another. It gives what is highest of the chosen triangles (in ascending order), cut along their
/// edges and the lines where they pierce each other (`grounds`), as far as those are seen. What is
/// under triangles that stay `whole` (in ascending order too) is left out. Of heights within
/// `tolerance_m` of each other the one of the triangle of lower number counts.
UpperPieces cut_to_upper(const Tin& tin, std::span<const std::uint32_t> chosen,
                         std::span<const std::uint32_t> whole,
                         std::span<const CommonGround> grounds, double tolerance_m);

/// The edges of triangles, each once, in order.
std::vector<PlanEdge> edges_of(const Tin& tin, std::span<const std::uint32_t> triangles);

} // namespace orograph
