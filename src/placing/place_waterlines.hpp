// SPDX-License-Identifier: GPL-3.0-or-later
// Where lines on the water are drawn.
#pragma once

#include "dem/surface.hpp"
#include "placing/placed_view.hpp"
#include "profiles/waterlines.hpp"

namespace orograph {

/// Six lines along the shores, ever farther apart; none where no shore is in the frame. The first
/// is as far from the shore as profiles are apart by default, on the page, where half of the shores
/// in the frame are nearer to the eye. REQUIRES a view and a page. Cost: that of `waterlines`.
Isolines place_waterlines(const PlacedView& placed, const Surface& surface, double pen_width_mm);

} // namespace orograph
