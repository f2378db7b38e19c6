// SPDX-License-Identifier: GPL-3.0-or-later
// What of a drawing lies in a box of the page.
#pragma once

#include "draw/drawing.hpp"
#include "geometry/api.hpp"
#include "geometry/box.hpp"

namespace orograph {

/// Cuts all strokes at the box's edges, and nowhere else: what is in it stays, on the page's step.
/// The page stays too. Texts aren't cut: those that lie outside go, and all others stay whole, as
/// they are wanted on two sheets that lie upon each other. REQUIRES strokes without map points, and
/// edges on the page's step.
OROGRAPH_API void cut_to(Drawing& drawing, const Box2& box_mm);

/// Of this size in the page's middle, its edges on the page's step.
OROGRAPH_API Box2 middle_of(const Page& page, Vec2 size_mm);

} // namespace orograph
