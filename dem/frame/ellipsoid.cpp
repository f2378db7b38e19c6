// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/frame/ellipsoid.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace orograph {
namespace {

struct PrincipalRadii {
  double meridian_m, prime_vertical_m;
};

PrincipalRadii principal_radii(const Ellipsoid& ellipsoid, double lat_deg) {
  const double e2 = ellipsoid.eccentricity_squared();
  const double sine = sin(Angle::degrees(lat_deg));
  const double w2 = 1 - e2 * sine * sine;
  const double prime_vertical_m = ellipsoid.semi_major_axis_m / std::sqrt(w2);
  return {prime_vertical_m * (1 - e2) / w2, prime_vertical_m};
}

} // namespace

void check(const Ellipsoid& ellipsoid) {
  if (!(ellipsoid.semi_major_axis_m > 0 && std::isfinite(ellipsoid.semi_major_axis_m)))
    throw Error(
        fmt::format("an ellipsoid with a semi-major axis of {} m", ellipsoid.semi_major_axis_m),
        "it is a positive length, 6378137 m for WGS 84");
  if (!(ellipsoid.inverse_flattening == 0 ||
        (ellipsoid.inverse_flattening > 1 && std::isfinite(ellipsoid.inverse_flattening))))
    throw Error(
        fmt::format("an ellipsoid with an inverse flattening of {}", ellipsoid.inverse_flattening),
        "it is above 1, 298.257223563 for WGS 84, or 0 for a sphere");
}

double euler_radius_m(const Ellipsoid& ellipsoid, double lat_deg, Angle azimuth) {
  const auto [meridian_m, prime_vertical_m] = principal_radii(ellipsoid, lat_deg);
  const auto [east, north] = direction_of_azimuth(azimuth);
  return 1 / (north * north / meridian_m + east * east / prime_vertical_m);
}

double mean_radius_m(const Ellipsoid& ellipsoid, double lat_deg) {
  const auto [meridian_m, prime_vertical_m] = principal_radii(ellipsoid, lat_deg);
  return std::sqrt(meridian_m * prime_vertical_m);
}

} // namespace orograph
