// SPDX-License-Identifier: GPL-3.0-or-later
// What a pass counts of its work, and how long its stages take.
#pragma once

#include <cstdint>
#include <limits>

namespace orograph {

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

struct Counts {
  std::uint64_t cut_vertices = 0, segments = 0;
  std::uint64_t pieces_before_collapse = 0, pieces_after_collapse = 0, largest_horizon = 0;
  std::uint64_t strokes = 0, points = 0, ties = 0, dropped_strokes = 0;
  std::uint64_t turned_over = 0; ///< triangles that the ellipsoid would turn over in plan
  double looked_at = 1;          ///< share of the ground that wasn't passed over as a whole
  /// Of overlays: things laid on the ground; of those the ones of which a part lies beside the
  /// terrain or over a void; and those of which nothing is on it, left out of the first.
  std::uint64_t draped = 0, draped_in_part = 0, not_draped = 0;
  std::uint64_t solids = 0, solid_edges = 0; ///< instances, and edges of all of them
};

/// By stage; kNotMeasured where there was none. Seconds of `cut`, `project` and `clip` are those of
/// all threads together.
struct StageSeconds {
  double read = kNotMeasured, place = kNotMeasured, facing = kNotMeasured, cut = kNotMeasured,
         project = kNotMeasured, clip = kNotMeasured, check = kNotMeasured, layout = kNotMeasured,
         write = kNotMeasured, total = kNotMeasured;
};

} // namespace orograph
