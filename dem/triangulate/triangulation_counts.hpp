// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace orograph {

/// What was met on the way from surveyed points and lines to a Tin.
struct TriangulationCounts {
  std::uint64_t points = 0;     ///< given, the vertices of lines included
  std::uint64_t merged = 0;     ///< points that lay where another one was
  double greatest_merged_m = 0; ///< how far apart in height they were at one place, at most
  std::uint64_t breaklines = 0;
  std::uint64_t crossings = 0;       ///< places where lines cross between their vertices
  double greatest_crossing_m = 0;    ///< how far apart in height the lines are there, at most
  std::uint64_t beyond_max_edge = 0; ///< triangles taken away
  std::uint64_t outside = 0;         ///< triangles outside the boundary
};

} // namespace orograph
