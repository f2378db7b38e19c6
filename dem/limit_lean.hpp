// SPDX-License-Identifier: GPL-3.0-or-later
// Cliffs that the ellipsoid would make lean over each other.
#pragma once

#include "dem/grid.hpp"

namespace orograph {

/// Where a vertex far from the ground frame's origin is so much higher than others beside it that a
/// triangle would be turned over seen from above, it leans by the height of the ground about it
/// alone (`LeanLimit`). So no triangle is turned over any more, wherever the lattice has none at
/// one height, and all that is asked of a surface seen from above can be asked of this one. In such
/// a grid no vertex leans farther than another beside it by more than a quarter of a side, either.
/// A grid without such triangles stays as it is. REQUIRES a grid on the earth without limits. Cost:
/// a pass over the heights at the speed of memory; steep blocks take some nanoseconds a vertex.
/// A grid without any that leans so far, as most are, is known to be upright from then on.
void limit_lean(Grid& grid);

} // namespace orograph
