// SPDX-License-Identifier: GPL-3.0-or-later
// Where on a terrain the ink of a drawing lies.
#pragma once

#include "geometry/angle.hpp"
#include "geometry/vec.hpp"

#include <vector>

#include "profile_lines.hpp"
#include "read_strokes.hpp"

namespace orograph {

/// Drawings are compared on a picture of this width: an A4 page less margins.
constexpr double kPicture_mm = 277;

/// The picture of a place, x by its column, y = up_mm + per_height z + per_way v: z its height, v
/// its way north of the southmost row, in metres.
struct Fit {
  double per_height = 0, per_way = 0, up_mm = 0; ///< mm on the picture a metre
  double median_mm = 0; ///< of how far the outlines of ink and terrain are apart
  /// Of the rays, from the two factors.
  Angle elevation() const;
};

struct PlacedDrawing {
  Strokes strokes_mm; ///< x from 0 (the first column) to kPicture_mm (the last one)
  Fit fit;
};

/// Turns the drawing by the quarter that fits (PostScript is often in landscape) and scales it to
/// the picture's width, then fits by least squares to the two outlines that any view shows: the
/// southmost line, or the lowest of all where the underside is drawn, and the skyline. The angle is
/// taken as `elevation` unless another, up to 5 degrees off, fits more than twice as well. REQUIRES
/// a parallel view from the south, and that the picture is as wide as the terrain.
PlacedDrawing place_drawing(const ProfileLines& lines, const Strokes& strokes, Angle elevation);

} // namespace orograph
