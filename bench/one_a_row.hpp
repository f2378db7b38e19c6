// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/extent.hpp"
#include "placing/map_spec.hpp"

namespace orograph {

/// A view of a grid from an azimuth and elevation (degrees), with as many profiles as it has rows
/// and nothing but profiles drawn.
inline MapSpec one_profile_a_row(const Surface& surface, double azimuth_deg, double elevation_deg) {
  MapSpec spec;
  spec.view.from_azimuth = Angle::degrees(azimuth_deg);
  spec.view.from_elevation = Angle::degrees(elevation_deg);
  spec.style.plan = GroundSpacing{cell_size_m(surface)};
  spec.style.layers = {"profiles"};
  return spec;
}

} // namespace orograph
