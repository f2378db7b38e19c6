// SPDX-License-Identifier: GPL-3.0-or-later
// From what was surveyed to one vertex a place.
#pragma once

#include "dem/triangulate/triangulate.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

struct MergedPlaces {
  std::vector<Vec3> vertices_m; ///< all at different places, in an order of place
  /// Vertices of each breakline and of each ring of the boundary, in their order; those of a ring
  /// without heights are empty.
  std::vector<std::vector<std::uint32_t>> breaklines, rings;
  std::uint64_t points = 0, merged = 0;
  double greatest_merged_m = 0;
};

/// True if every point of the ring has a height.
bool has_heights(const BoundaryRing& ring);

/// Points at one place become one vertex, by rule (1) of `triangulate`. The vertices don't depend
/// on the order in which points and lines are given. Throws Error where there are more points than
/// a Tin can number.
MergedPlaces merge_places(const Survey& survey);

} // namespace orograph
