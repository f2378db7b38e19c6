// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/frame/local_frame.hpp"

#include "geometry/error.hpp"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/LocalCartesian.hpp>
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

struct LocalFrame::Exact {
  GeographicLib::LocalCartesian cartesian;
};

LocalFrame::LocalFrame(double lon_deg, double lat_deg, const Ellipsoid& ellipsoid)
    : ellipsoid_(ellipsoid), origin_lon_deg_(lon_deg), origin_lat_deg_(lat_deg) {
  check(ellipsoid);
  if (!(std::isfinite(lon_deg) && std::abs(lat_deg) <= 90))
    throw Error(fmt::format("no place at longitude {}, latitude {} degrees", lon_deg, lat_deg),
                "latitudes are within -90 to 90; longitude comes first");
  exact_ = std::make_shared<const Exact>(Exact{GeographicLib::LocalCartesian(
      lat_deg, lon_deg, 0,
      GeographicLib::Geocentric(ellipsoid.semi_major_axis_m, ellipsoid.flattening()))});
}

Vec3 LocalFrame::to_frame(double lon_deg, double lat_deg, double h_m) const {
  if (lon_deg == origin_lon_deg_ && lat_deg == origin_lat_deg_) return {0, 0, h_m};
  Vec3 frame_m;
  exact_->cartesian.Forward(lat_deg, lon_deg, h_m, frame_m.x, frame_m.y, frame_m.z);
  return frame_m;
}

GeoPoint LocalFrame::to_geodetic(Vec3 frame_m) const {
  GeoPoint point;
  exact_->cartesian.Reverse(frame_m.x, frame_m.y, frame_m.z, point.lat_deg, point.lon_deg,
                            point.h_m);
  point.lon_deg += 360 * std::round((origin_lon_deg_ - point.lon_deg) / 360);
  return point;
}

DistanceAzimuth distance_and_azimuth(const GeoPoint& from, const GeoPoint& to,
                                     const Ellipsoid& ellipsoid) {
  check(ellipsoid);
  const GeographicLib::Geodesic geodesic(ellipsoid.semi_major_axis_m, ellipsoid.flattening());
  double distance_m = 0, azimuth_deg = 0, arrival_deg = 0;
  geodesic.Inverse(from.lat_deg, from.lon_deg, to.lat_deg, to.lon_deg, distance_m, azimuth_deg,
                   arrival_deg);
  if (azimuth_deg < 0) azimuth_deg += 360;
  if (azimuth_deg == 0 || azimuth_deg == 360) azimuth_deg = 0; // not -0, nor a hair west of north
  return {distance_m, Angle::degrees(azimuth_deg)};
}

} // namespace orograph
