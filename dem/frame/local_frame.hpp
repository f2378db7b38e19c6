// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of the earth, how it curves, and a frame that stands on it.
#pragma once

#include "geometry/angle.hpp"
#include "geometry/vec.hpp"

#include <memory>

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

/// Longitudes east and latitudes north, geodetic. A longitude may be any number of whole turns
/// off; a latitude is within -90 to 90. Heights are metres along the ellipsoid's normal; what they
/// count from (ellipsoid or geoid) is the caller's, who has all of one kind.
struct GeoPoint {
  double lon_deg = 0, lat_deg = 0, h_m = 0;
};

/// The ground frame of a terrain in degrees: right-handed, x east, y north and z up (the
/// ellipsoid's normal) at the origin, which lies at height 0. Away from the origin the ellipsoid
/// curves down below z = 0. True at any distance and at the poles as well, where all longitudes
/// meet and to_geodetic returns some. GeographicLib's answers, within 4e-9 m (measured on the
/// earth up to 300 km from the origin; the rounding of geocentric coordinates).
class LocalFrame {
public:
  /// Throws Error where the origin isn't a place or the ellipsoid no ellipsoid.
  LocalFrame(double lon_deg, double lat_deg, const Ellipsoid& ellipsoid = {});

  const Ellipsoid& ellipsoid() const { return ellipsoid_; }
  double origin_lon_deg() const { return origin_lon_deg_; } ///< as given
  double origin_lat_deg() const { return origin_lat_deg_; }

  /// NaN for a latitude beyond the poles. Above the origin as given exactly so, as a lattice's
  /// vertex there is: an eye on it is on it.
  Vec3 to_frame(double lon_deg, double lat_deg, double h_m) const;
  /// The longitude is within half a turn of the origin's as given: 359 to 361 degrees about an
  /// origin at 360, and whatever else a file counts in.
  GeoPoint to_geodetic(Vec3 frame_m) const;

private:
  Ellipsoid ellipsoid_;
  double origin_lon_deg_, origin_lat_deg_;
  struct Exact;
  std::shared_ptr<const Exact> exact_; ///< never changes: copies of a frame share it
};

/// Along the shortest path on the ellipsoid, heights apart.
struct DistanceAzimuth {
  double distance_m;
  Angle azimuth; ///< at the first point, clockwise from north, in [0, 360)
};
/// Throws Error where the ellipsoid is none; NaN for a latitude beyond the poles.
DistanceAzimuth distance_and_azimuth(const GeoPoint& from, const GeoPoint& to,
                                     const Ellipsoid& ellipsoid = {});

} // namespace orograph
