// SPDX-License-Identifier: GPL-3.0-or-later
// From triangles as files have them to a Tin.
#pragma once

#include "dem/tin.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace orograph {

/// Triangles as a file holds them: in any orientation, points perhaps repeated, nothing checked but
/// the indices' range.
struct TriangleSoup {
  std::vector<Vec3> points_m; ///< ground frame
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct TinFromTriangles {
  Tin tin;
  std::vector<std::string> notes; ///< what was turned or dropped, a sentence each
};

/// Merges points that are equal in all three coordinates, drops vertices without triangles, turns
/// triangles counterclockwise (walls as their neighbours have it) and finds neighbours. The order
/// of vertices and triangles stays.
/// Triangles of no area (two or three vertices at one point, or all on a line in space) are dropped
/// and counted in a note.
///
/// Throws Error where the triangles aren't a terrain (they overlap seen from above, an edge has
/// three), unless `repair`: then they are reduced to their upper surface
/// (dem/mesh/upper_surface.hpp), and notes say what was dropped and cut. Also where a coordinate
/// isn't finite and where no triangle has an area. Messages number points and triangles as the soup
/// does; `source` names the file in them.
TinFromTriangles tin_from_triangles(const TriangleSoup& soup, bool repair,
                                    const std::string& source);

} // namespace orograph
