// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep of one view with its stages measured one by one, on one thread.
#pragma once

#include "cli/profile_batch.hpp"

#include <functional>
#include <vector>

#include "bench/stages/meter.hpp"
#include "bench/stages/staged_view.hpp"

namespace orograph {

struct SweepMeters {
  Meter lines;    ///< slabs of lines: what of them is visible, and the horizon raised by them
  Meter profiles; ///< profiles clipped
};

struct SweepFound {
  std::vector<LinePart> visible; ///< of drawn lines; strip by strip, not joined
  std::size_t cut_vertices = 0;
};

/// Cuts, projects and clips all profiles, front to back, in the strips of `sweep_strips`.
/// `profile_done` gets each of them with its visible runs by strip. The strips take turns at every
/// profile, so that a look at the clock is shared by all of them.
SweepFound sweep_front_to_back(const StagedView& view, const std::vector<SweptLine>& lines,
                               SweepMeters& meters,
                               const std::function<void(const ProfileInWork&)>& profile_done);

} // namespace orograph
