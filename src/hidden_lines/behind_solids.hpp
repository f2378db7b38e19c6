// SPDX-License-Identifier: GPL-3.0-or-later
// What solids hide of lines of the terrain.
#pragma once

#include "horizon/clip_profile.hpp"
#include "profiles/profile.hpp"
#include "solids/solids_in_view.hpp"

#include <vector>

#include "hidden_lines/line_parts.hpp"
#include "hidden_lines/line_pass.hpp"

namespace orograph {

/// Takes out of the runs of a profile what is behind solids. Cost: a look at each span, and the
/// triangles of solids that are in front of it.
void leave_out_behind(const SolidsInView& solids, const Profile& profile,
                      std::vector<VisibleRun>& runs);

/// The same of parts of lines, by line.
std::vector<LinePart> not_behind(const SolidsInView& solids, const LinePass& lines,
                                 const std::vector<LinePart>& parts);

} // namespace orograph
