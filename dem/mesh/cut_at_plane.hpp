// SPDX-License-Identifier: GPL-3.0-or-later
// A Tin on one side of a plane.
#pragma once

#include "dem/mesh/half_space.hpp"
#include "dem/tin.hpp"

namespace orograph {

/// `keep_within` (keep_within.hpp) of one half-space. Vertices without a triangle are left out.
Tin cut_at_plane(const Tin& tin, const HalfSpace& space);

} // namespace orograph
