// SPDX-License-Identifier: GPL-3.0-or-later
// A profile in the visibility plane.
#pragma once

#include <cstdint>
#include <vector>

namespace orograph {

/// Of the visibility plane.
struct XRange {
  double begin, end;
};

/// Vertices `first` to `last` of a profile, with ground between each and the next.
struct VertexRun {
  std::uint32_t first, last;
};

/// All vertices of a profile; X never falls along a run.
struct ProjectedProfile {
  std::vector<double> x, y;
  std::vector<VertexRun> runs;
};

} // namespace orograph
