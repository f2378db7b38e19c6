// SPDX-License-Identifier: GPL-3.0-or-later
// A view as it was clipped, asked of sight through every triangle: at places of its lines, and
// where drawn pieces end.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"

#include <cstdint>
#include <string>

namespace orograph {

struct Judged {
  std::uint64_t scenes = 0, refused = 0; ///< of these; refused: no such view of that terrain
  std::uint64_t points = 0;
  std::uint64_t ties = 0; ///< within the visibility tolerance of what is in front
  /// Where a rounding of the place in double decides which way it goes, and lines whose whole
  /// picture is no longer than the tolerance.
  std::uint64_t in_rounding = 0;
  std::uint64_t wrong = 0;     ///< hidden but drawn, or visible but missing
  std::uint64_t ends = 0;      ///< of drawn pieces, within a line
  std::uint64_t ends_tied = 0; ///< of these, what truly ends nowhere near: of ties
  double farthest_mm =
      0; ///< from another end to where the line truly disappears, to a power of ten
  std::string first_wrong;

  void add(const Judged& other);
};

/// Draws every fold and asks about `points` places of profiles, edges and lines on the ground, and
/// of the ends as many again. A terrain or a view that is refused with an Error counts as refused.
/// REQUIRES a grid on a map plane without a CRS. With `as_tin` the same triangles are drawn as a
/// TIN.
Judged judge_view(TerrainData terrain, MapSpec spec, std::uint64_t points, std::uint64_t seed,
                  bool as_tin = false);

} // namespace orograph
