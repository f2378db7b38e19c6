// SPDX-License-Identifier: GPL-3.0-or-later
// Making a pen's way shorter by exchanging where it goes next.
#pragma once

#include "draw/pen_route.hpp"

namespace orograph {

/// The route after all exchanges of links that make it shorter: a part of it turned round (2-opt),
/// one to three lines in a row moved to elsewhere, either way round (Or-opt), a ring begun
/// elsewhere. Of each end the ten nearest others are tried, so that of five lines or fewer no such
/// change is left that gains; of more, hardly any. Never longer than it was. The same route gives
/// the same one. Memory O(n), time about n log n.
PenRoute shortened(const PenLines& lines, Vec2 pen, const PenRoute& route);

} // namespace orograph
