// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of a sheet that profiles run through.
#pragma once

#include "hidden_lines/profile_stages.hpp"
#include "hidden_lines/sheet_strip.hpp"

#include <span>
#include <vector>

namespace orograph {

/// Each of a sector's profiles with the triangles of its spans. REQUIRES profiles that are cut, in
/// order of their depth, and outlive it. On all cores. Cost: a look at each triangle.
std::vector<SheetProfile> sheet_profiles(const SheetInWork& sheet,
                                         std::span<TimedProfile> profiles);

} // namespace orograph
