// SPDX-License-Identifier: GPL-3.0-or-later
// Azimuths under a panorama's strips, altitudes beside them.
#pragma once

#include "map/furniture_pen.hpp"
#include "placing/placed_view.hpp"

#include <optional>

namespace orograph {

/// Under each strip marks at whole degrees, as close as there is room, their figures, and the
/// compass's directions. `from_deg` is the azimuth of the left side; with `has_line` a line along
/// the strip, too.
void draw_azimuths(FurniturePen& pen, const Panorama& panorama, double from_deg, double text_mm,
                   const Box2& inner_mm, bool has_line);

/// To the left of each strip marks and figures of altitudes; to its right where the sea's horizon
/// is, that far below the horizontal, if that is known and on the strip.
void draw_altitudes(FurniturePen& pen, const Panorama& panorama, std::optional<double> dip_deg,
                    double text_mm, bool has_line);

/// How far below the horizontal an eye sees the sea's horizon. None at or under the sea.
std::optional<double> dip_deg(double eye_height_m, double radius_m, double refraction);

} // namespace orograph
