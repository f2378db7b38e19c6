// SPDX-License-Identifier: GPL-3.0-or-later
// The polylines of a drawing that any tool made.
#pragma once

#include "geometry/vec.hpp"

#include <string>
#include <vector>

namespace orograph {

using Strokes = std::vector<std::vector<Vec2>>;

/// In the file's own units, y up. By extension:
///  - .svg: absolute M and L of every path, points of every polyline; transforms aren't applied;
///  - .fig: polylines of xfig;
///  - .ps, .eps: what is stroked, by Ghostscript and `strokes_ps`;
///  - else text: `x y` a line, an empty line between polylines.
/// A polyline that begins where the one before it ends continues it. Throws Error where the file
/// can't be read or holds none.
Strokes read_strokes(const std::string& path, const std::string& strokes_ps);

} // namespace orograph
