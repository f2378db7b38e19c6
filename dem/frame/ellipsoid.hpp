// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of the earth, and how it curves.
#pragma once

#include "geometry/angle.hpp"

namespace orograph {

/// WGS 84 unless told otherwise.
struct Ellipsoid {
  double semi_major_axis_m = 6378137;
  double inverse_flattening = 298.257223563; ///< 0 for a sphere, as GDAL has it

  double flattening() const { return inverse_flattening == 0 ? 0 : 1 / inverse_flattening; }
  double eccentricity_squared() const { return flattening() * (2 - flattening()); }
};

/// Throws Error unless the axis is a positive length and the inverse flattening is 0 or above 1.
void check(const Ellipsoid& ellipsoid);

/// Euler's radius of curvature: of the section that an upright plane in that azimuth (clockwise
/// from north) makes at a latitude. The sea drops by d^2 / 2R at a small distance d that way.
double euler_radius_m(const Ellipsoid& ellipsoid, double lat_deg, Angle azimuth);

/// Gauss's radius: the mean of Euler's over all azimuths (the geometric mean of the meridian's and
/// the prime vertical's, which differ by less than 0.68 % on the earth).
double mean_radius_m(const Ellipsoid& ellipsoid, double lat_deg);

} // namespace orograph
