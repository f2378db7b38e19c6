// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/render_settings.hpp"
#include "dem/extent.hpp"

namespace orograph {

/// A view of a grid from an azimuth and elevation (degrees), with as many profiles as it has rows
/// and nothing but profiles drawn.
inline RenderSettings one_profile_a_row(const Surface& surface, double azimuth_deg,
                                        double elevation_deg) {
  RenderSettings settings;
  settings.from_azimuth = Angle::degrees(azimuth_deg);
  settings.from_elevation = Angle::degrees(elevation_deg);
  settings.plan = GroundSpacing{cell_size_m(surface)};
  settings.layers = {"profiles"};
  return settings;
}

} // namespace orograph
