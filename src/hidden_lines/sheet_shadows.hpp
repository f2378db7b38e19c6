// SPDX-License-Identifier: GPL-3.0-or-later
// What the triangles of a sheet, or of a block that is closed below, hide of solids.
#pragma once

#include "hidden_lines/solid_lines.hpp"
#include "solids/solids_in_view.hpp"

#include <vector>

namespace orograph {

/// For each solid what triangles of a sheet that may stand in front of it hide, whichever side they
/// show: seen on its upper side one hides nothing that lies on it, and on its underside that too.
/// Of a closed block the same of its faces, walls and base too, that are turned to the eye.
/// REQUIRES ground.sheet. Cost: a look at each triangle, and those that are found.
std::vector<std::vector<TriangleShadow>> sheet_shadows(const HidingGround& ground,
                                                       const SolidsInView& solids,
                                                       const std::vector<double>& touching_m);

} // namespace orograph
