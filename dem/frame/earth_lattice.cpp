// SPDX-License-Identifier: GPL-3.0-or-later
// Every table value is a product or a sum without cancellation, so that its error is a share of the
// distance from the origin and not of the earth's radius:
//   1 - cos(d) is 2 sin^2(d / 2), of latitudes as of longitudes;
//   N - N0 comes from w0^2 - w^2 = e^2 sin(lat - lat0) sin(lat + lat0), where N = a / w.
#include "dem/frame/earth_lattice.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace orograph {
namespace {

double sine(double deg) {
  return sin(Angle::degrees(deg));
}
double cosine(double deg) {
  return cos(Angle::degrees(deg));
}
double one_minus_cosine(double deg) {
  const double half = sine(deg / 2);
  return 2 * half * half;
}

// Whole turns go first: taking 360 from a longitude is exact where it matters, and so is what is
// left to round the difference itself.
double degrees_east(double lon_deg, double origin_lon_deg) {
  const double origin = std::remainder(origin_lon_deg, 360);
  return (lon_deg - 360 * std::round((lon_deg - origin) / 360)) - origin;
}

} // namespace

EarthLattice::Row EarthLattice::row_at(double lat_deg, double origin_lat_deg,
                                       const Ellipsoid& ellipsoid) {
  const double a = ellipsoid.semi_major_axis_m, e2 = ellipsoid.eccentricity_squared();
  const double s = sine(lat_deg), s0 = sine(origin_lat_deg), c0 = cosine(origin_lat_deg);
  const double w = std::sqrt(1 - e2 * s * s), w0 = std::sqrt(1 - e2 * s0 * s0);
  const double n = a / w, n0 = a / w0;
  const double north = lat_deg - origin_lat_deg, sum = lat_deg + origin_lat_deg;
  const double sin_north = sine(north);

  const double n_more = a * e2 * sin_north * sine(sum) / (w * w0 * (w + w0));        // n - n0
  const double along_axis = n_more * s + 2 * n0 * sine(north / 2) * cosine(sum / 2); // ns - n0 s0
  return {n * cosine(lat_deg),
          cosine(lat_deg),
          n * sin_north - e2 * c0 * along_axis,
          sin_north,
          n_more - n * one_minus_cosine(north) - e2 * s0 * along_axis,
          cosine(north)};
}

EarthLattice::EarthLattice(const DegreeLattice& lattice, const LocalFrame& frame,
                           double exaggeration)
    : degrees_(lattice), frame_(frame), exaggeration_(exaggeration),
      origin_sine_(sine(frame.origin_lat_deg())), origin_cosine_(cosine(frame.origin_lat_deg())) {
  for (int column = 0; column < lattice.columns; ++column) {
    const double east = degrees_east(lattice.lon_deg(column), frame.origin_lon_deg());
    sine_.push_back(sine(east));
    versine_.push_back(one_minus_cosine(east));
  }
  for (int row = 0; row < lattice.rows; ++row) {
    const double lat_deg = lattice.lat_deg(row);
    if (!(std::abs(lat_deg) <= 90))
      throw Error(fmt::format("latitude {} degrees in row {}", lat_deg, row),
                  "latitudes are within -90 to 90");
    rows_.push_back(row_at(lat_deg, frame.origin_lat_deg(), frame.ellipsoid()));
  }
}

Vec3 EarthLattice::limited(Vec3 at, int column, int row, double height_m) const {
  const LeanLimit* const limit = limits_->of(column, row);
  if (!limit || std::isnan(height_m)) return at;
  const auto c = static_cast<std::size_t>(column);
  const Vec3 leaning = place(rows_[static_cast<std::size_t>(row)], sine_[c], versine_[c],
                             exaggeration_ * limit->of(height_m));
  return {leaning.x, leaning.y, at.z};
}

template <class Height>
void EarthLattice::place_row(int row, int first, std::span<const Height> heights_m,
                             double* __restrict x_m, double* __restrict y_m,
                             double* __restrict z_m) const {
  const Row of_row = rows_[static_cast<std::size_t>(row)];
  const double* __restrict sines = sine_.data() + first;
  const double* __restrict versines = versine_.data() + first;
  const Height* __restrict heights = heights_m.data();
  const std::size_t count = heights_m.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 at = place(of_row, sines[i], versines[i], exaggeration_ * heights[i]);
    x_m[i] = at.x;
    y_m[i] = at.y;
    z_m[i] = at.z;
  }
  if (!limits_) return;
  for (const LeanLimit& limit : limits_->of_row(row)) {
    const auto i = static_cast<std::size_t>(limit.column - first);
    if (limit.column < first || i >= count) continue;
    const Vec3 at = limited({x_m[i], y_m[i], 0}, limit.column, row, heights[i]);
    x_m[i] = at.x;
    y_m[i] = at.y;
  }
}

void EarthLattice::row_vertices_m(int row, int first, std::span<const float> heights_m,
                                  std::span<double> x_m, std::span<double> y_m,
                                  std::span<double> z_m) const {
  place_row(row, first, heights_m, x_m.data(), y_m.data(), z_m.data());
}

void EarthLattice::row_vertices_m(int row, int first, std::span<const double> heights_m,
                                  std::span<double> x_m, std::span<double> y_m,
                                  std::span<double> z_m) const {
  place_row(row, first, heights_m, x_m.data(), y_m.data(), z_m.data());
}

Vec2 EarthLattice::column_row_of(const GeoPoint& place) const {
  const double middle_deg = degrees_.middle_lon_deg();
  const double east_deg = middle_deg + std::remainder(place.lon_deg - middle_deg, 360);
  return {(east_deg - degrees_.first_lon_deg) / degrees_.lon_step_deg,
          (place.lat_deg - degrees_.first_lat_deg) / degrees_.lat_step_deg};
}

} // namespace orograph
