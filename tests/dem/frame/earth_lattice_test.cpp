// SPDX-License-Identifier: GPL-3.0-or-later
// The places of a lattice against GeographicLib's, and against the ellipsoid's definition in
// extended precision.
#include "dem/frame/earth_lattice.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/LocalCartesian.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace orograph::earth_lattice_test {
namespace {

using Long = long double;
struct LongVec3 {
  Long x, y, z;
};

LongVec3 geocentric(const Ellipsoid& ellipsoid, Long lon_deg, Long lat_deg, Long h_m) {
  constexpr Long kRadian = std::numbers::pi_v<Long> / 180;
  const Long f = ellipsoid.inverse_flattening == 0 ? 0 : 1 / Long(ellipsoid.inverse_flattening);
  const Long e2 = f * (2 - f), lon = std::fmod(lon_deg, Long(360)) * kRadian,
             lat = lat_deg * kRadian;
  const Long n =
      Long(ellipsoid.semi_major_axis_m) / std::sqrt(1 - e2 * std::sin(lat) * std::sin(lat));
  return {(n + h_m) * std::cos(lat) * std::cos(lon), (n + h_m) * std::cos(lat) * std::sin(lon),
          (n * (1 - e2) + h_m) * std::sin(lat)};
}

// The difference of two geocentric places, turned to the origin's east, north and up.
Vec3 by_definition(const LocalFrame& frame, double lon_deg, double lat_deg, double h_m) {
  constexpr Long kRadian = std::numbers::pi_v<Long> / 180;
  const Long lon0 = std::fmod(Long(frame.origin_lon_deg()), Long(360)) * kRadian;
  const Long lat0 = Long(frame.origin_lat_deg()) * kRadian;
  const LongVec3 p = geocentric(frame.ellipsoid(), lon_deg, lat_deg, h_m);
  const LongVec3 o =
      geocentric(frame.ellipsoid(), frame.origin_lon_deg(), frame.origin_lat_deg(), 0);
  const LongVec3 d{p.x - o.x, p.y - o.y, p.z - o.z};
  const Long out = d.x * std::cos(lon0) + d.y * std::sin(lon0);
  return {static_cast<double>(d.y * std::cos(lon0) - d.x * std::sin(lon0)),
          static_cast<double>(d.z * std::cos(lat0) - out * std::sin(lat0)),
          static_cast<double>(out * std::cos(lat0) + d.z * std::sin(lat0))};
}

Vec3 of_geographiclib(const LocalFrame& frame, double lon_deg, double lat_deg, double h_m) {
  const GeographicLib::LocalCartesian cartesian(
      frame.origin_lat_deg(), frame.origin_lon_deg(), 0,
      GeographicLib::Geocentric(frame.ellipsoid().semi_major_axis_m,
                                frame.ellipsoid().flattening()));
  Vec3 p;
  cartesian.Forward(lat_deg, lon_deg, h_m, p.x, p.y, p.z);
  return p;
}

// A lattice that has a vertex at a place, and where.
struct LatticeVertex {
  DegreeLattice lattice;
  int column, row;
};
LatticeVertex lattice_with_vertex(Random& random, double lon_deg, double lat_deg) {
  LatticeVertex made{{}, random.whole(0, 20), random.whole(0, 20)};
  const double step_deg = random.pick({1. / 3600, 1. / 1200, 0.001, 0.1});
  made.lattice.lon_step_deg = random.pick({1.0, 2.0, -1.0}) * step_deg;
  made.lattice.lat_step_deg = random.pick({-1.0, 1.0}) * step_deg;
  made.lattice.first_lon_deg = lon_deg - made.column * made.lattice.lon_step_deg;
  made.lattice.first_lat_deg = lat_deg - made.row * made.lattice.lat_step_deg;
  // Rows end where the vertex is, so that none is beyond a pole.
  const bool ends_at_pole =
      std::abs(made.lattice.first_lat_deg + 25 * made.lattice.lat_step_deg) > 90;
  made.lattice.columns = made.column + random.whole(1, 4);
  made.lattice.rows = made.row + (ends_at_pole ? 1 : random.whole(1, 4));
  return made;
}

} // namespace

TEST_CASE("10,000 vertices within nanometres of LocalCartesian, nearer still to the truth") {
  Random random(1);
  double from_theirs_m = 0, theirs_from_truth_m = 0, from_truth = 0, from_truth_m = 0;
  for (int i = 0; i < 10000; ++i) {
    const Ellipsoid ellipsoid =
        random.pick({Ellipsoid{}, Ellipsoid{6377397.155, 299.1528128}, Ellipsoid{6371000, 0}});
    const double lat_deg = random.between(-85, 85), lon_deg = random.between(-180, 180);
    double lat0_deg = 0, lon0_deg = 0;
    GeographicLib::Geodesic::WGS84().Direct(lat_deg, lon_deg, random.between(-180, 180),
                                            random.pick({10., 1e3, 3e4, 3e5}) * random.share(),
                                            lat0_deg, lon0_deg);
    const LocalFrame frame(lon0_deg + 360 * random.whole(-1, 1), lat0_deg, ellipsoid);
    const auto [lattice, column, row] =
        lattice_with_vertex(random, lon_deg + 360 * random.whole(-1, 1), lat_deg);
    const double h_m = random.between(-500, 9000);
    const double lon = lattice.first_lon_deg + column * lattice.lon_step_deg;
    const double lat = lattice.first_lat_deg + row * lattice.lat_step_deg;
    CAPTURE(lon, lat, h_m, frame.origin_lon_deg(), lat0_deg, ellipsoid.inverse_flattening);

    const Vec3 ours = EarthLattice(lattice, frame).vertex_m(column, row, h_m);
    const Vec3 theirs = of_geographiclib(frame, lon, lat, h_m);
    const Vec3 truth = by_definition(frame, lon, lat, h_m);
    REQUIRE(length(ours - theirs) <= 1e-8);
    from_theirs_m = std::max(from_theirs_m, length(ours - theirs));
    theirs_from_truth_m = std::max(theirs_from_truth_m, length(theirs - truth));
    from_truth_m = std::max(from_truth_m, length(ours - truth));
    // What is taken to be the truth has a few 1e-12 m of its own: 64 bits for the earth's radius.
    from_truth = std::max(from_truth, (length(ours - truth) - 5e-12) / length(truth));
  }
  INFO("lattice from LocalCartesian " << from_theirs_m << " m; LocalCartesian from the truth "
                                      << theirs_from_truth_m << " m; lattice from the truth "
                                      << from_truth_m << " m, a share of " << from_truth);
  CHECK(from_theirs_m <= 4e-9); // LocalCartesian's own error
  CHECK(from_truth_m <= 2e-10);
  if (std::numeric_limits<Long>::digits >= 64) CHECK(from_truth <= 6e-16);
}

TEST_CASE("the vertices of a row are bit for bit those one by one") {
  Random random(2);
  for (const int columns : {1, 2, 7, 500}) {
    const DegreeLattice lattice{-71.5, 1. / 3600, columns, 44.6, -1. / 3600, 3};
    const LocalFrame frame(-71.3, 44.27);
    const auto count = static_cast<std::size_t>(columns);
    std::vector<float> floats(count);
    std::vector<double> doubles(count), x(count), y(count), z(count);
    for (std::size_t c = 0; c < count; ++c) {
      doubles[c] = random.chance(0.1) ? std::nan("") : random.between(-500, 9000);
      floats[c] = static_cast<float>(doubles[c]);
    }
    for (int row = 0; row < lattice.rows; ++row)
      for (const double exaggeration : {1.0, 1.5, -0.3})
        for (const bool in_float : {false, true}) {
          const EarthLattice places(lattice, frame, exaggeration);
          const int first = random.whole(0, columns - 1), last = random.whole(first, columns - 1);
          const auto part = [&](auto& row_of) {
            return std::span(row_of).subspan(static_cast<std::size_t>(first),
                                             static_cast<std::size_t>(last - first + 1));
          };
          if (in_float)
            places.row_vertices_m(row, first, part(floats), part(x), part(y), part(z));
          else
            places.row_vertices_m(row, first, part(doubles), part(x), part(y), part(z));
          for (int column = first; column <= last; ++column) {
            const auto c = static_cast<std::size_t>(column);
            const double height = in_float ? static_cast<double>(floats[c]) : doubles[c];
            const Vec3 at = places.vertex_m(column, row, height);
            CAPTURE(columns, column, row, exaggeration, in_float, height);
            if (std::isnan(height)) {
              REQUIRE((std::isnan(x[c]) && std::isnan(y[c]) && std::isnan(z[c])));
            } else {
              REQUIRE((at == Vec3{x[c], y[c], z[c]}));
            }
          }
        }
  }
}

TEST_CASE("exaggeration lifts along the upright and leaves the sea where it is") {
  const DegreeLattice lattice{7.1, 0.5, 1, 46.2, -1, 1};
  const LocalFrame frame(8.5, 45);
  const EarthLattice places(lattice, frame, 5);
  const float heights[] = {0, 1000};
  Vec3 at[2];
  for (int k = 0; k < 2; ++k)
    places.row_vertices_m(0, 0, {heights + k, 1}, {&at[k].x, 1}, {&at[k].y, 1}, {&at[k].z, 1});
  CHECK(length(at[0] - frame.to_frame(7.1, 46.2, 0)) <= 1e-8);
  CHECK(length(at[1] - frame.to_frame(7.1, 46.2, 5000)) <= 1e-8);
}

TEST_CASE("nothing happens at the antimeridian, at 0 and at 360 degrees") {
  // Steps of a 64th, so that a turn more or less rounds nothing.
  const double step = 1. / 64;
  for (const double origin_deg : {180.25, -179.75, 540.25}) {
    const LocalFrame frame(origin_deg, -16.5);
    const DegreeLattice crossing{179, step, 129, -16, -step, 3};
    const EarthLattice places(crossing, frame);
    for (const double turn : {-360., 360., 720.}) {
      DegreeLattice turned = crossing;
      turned.first_lon_deg += turn;
      const EarthLattice same(turned, frame);
      for (int column = 0; column < crossing.columns; ++column)
        REQUIRE(same.vertex_m(column, 1, 300) == places.vertex_m(column, 1, 300));
    }
    // Two tiles that meet at the antimeridian have one edge.
    const EarthLattice west({179, step, 65, -16, -step, 3}, frame);
    const EarthLattice east({-180, step, 65, -16, -step, 3}, frame);
    for (int row = 0; row < 3; ++row) CHECK(west.vertex_m(64, row, 7) == east.vertex_m(0, row, 7));
    // Columns follow each other at one distance.
    const auto apart_m = [&](int column) {
      return length(places.vertex_m(column, 1, 0) - places.vertex_m(column - 1, 1, 0));
    };
    CHECK(apart_m(1) == Approx(1672.28).epsilon(1e-5));
    for (int column = 2; column < crossing.columns; ++column)
      REQUIRE(std::abs(apart_m(column) - apart_m(1)) <= 1e-9);
  }
  // The same at Greenwich in a grid from 0 to 360.
  const LocalFrame frame(0.25, 51);
  const EarthLattice here({-1, step, 129, 51, -step, 1}, frame);
  const EarthLattice there({359, step, 129, 51, -step, 1}, frame);
  for (int column = 0; column < 129; ++column)
    REQUIRE(here.vertex_m(column, 0, 10) == there.vertex_m(column, 0, 10));
}

TEST_CASE("right up to the poles and on the far side; nothing beyond") {
  for (const double pole_deg : {-90., 90.}) {
    const LocalFrame frame(30, pole_deg - std::copysign(0.5, pole_deg));
    const EarthLattice places({-180, 36, 11, pole_deg, -std::copysign(0.25, pole_deg), 9}, frame);
    for (int column = 0; column < 11; ++column) {
      CHECK(length(places.vertex_m(column, 0, 50) - places.vertex_m(0, 0, 50)) <= 1e-9);
      for (int row = 0; row < 9; ++row) {
        const double lat_deg = pole_deg - std::copysign(0.25, pole_deg) * row;
        REQUIRE(length(places.vertex_m(column, row, 50) -
                       by_definition(frame, -180 + 36 * column, lat_deg, 50)) <= 1e-9);
      }
    }
  }
  const LocalFrame frame(0, 0);
  const EarthLattice antipodes({179, 1, 3, 1, -1, 3}, frame);
  CHECK(antipodes.vertex_m(1, 1, 0).z == Approx(-2 * 6378137.).epsilon(1e-12));
  CHECK_THROWS_WITH(EarthLattice({0, 1, 2, 90.5, -1, 3}, frame),
                    "latitude 90.5 degrees in row 0: latitudes are within -90 to 90");
  CHECK_THROWS_AS(EarthLattice({0, 1, 2, -89, -1, 3}, frame), Error);
  CHECK_THROWS_AS(EarthLattice({0, 1, 2, std::nan(""), -1, 3}, frame), Error);
}

} // namespace orograph::earth_lattice_test
