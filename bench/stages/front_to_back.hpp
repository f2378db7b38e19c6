// SPDX-License-Identifier: GPL-3.0-or-later
// The pass of one view with its stages measured one by one, on one thread.
#pragma once

#include "bench/stages/meter.hpp"
#include "bench/stages/staged_view.hpp"
#include "hidden_lines/sector_in_work.hpp"

#include <functional>
#include <vector>

namespace orograph {

struct PassMeters {
  Meter lines;    ///< slabs of lines: what of them is visible, and the horizon raised by them
  Meter profiles; ///< profiles clipped
};

struct PassFound {
  std::vector<LinePart> visible; ///< of drawn lines; strip by strip, not joined
  std::size_t cut_vertices = 0;
};

/// Cuts, projects and clips all profiles, front to back, in the strips of `strips_pass`.
/// `profile_done` gets each of them with its visible runs by strip. The strips take turns at every
/// profile, so that a look at the clock is shared by all of them.
PassFound pass_front_to_back(const StagedView& view, const std::vector<EdgeLine>& lines,
                             PassMeters& meters,
                             const std::function<void(const ProfileInWork&)>& profile_done);

} // namespace orograph
