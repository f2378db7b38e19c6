// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solids/standing_solid.hpp"
#include "view/view.hpp"

namespace orograph {

/// Whether the eye of a perspective view is inside of a solid, however its closed parts lie in or
/// across each other: which of its triangles are above the eye is told by the same signs for
/// neighbours, so that none is counted twice and none is missed. An eye on the surface, to
/// rounding, may count as inside or not. Cost: a pass over the triangles.
bool holds_eye(const StandingSolid& standing, const View& view);

} // namespace orograph
