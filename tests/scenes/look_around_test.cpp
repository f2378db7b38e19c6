// SPDX-License-Identifier: GPL-3.0-or-later
// What an eye sees of places, and its skyline: against the ray walk, against all triangles in long
// double, and against GeographicLib's geodesics.
#include "dem/read/read_terrain.hpp"
#include "placing/eye_summit.hpp"
#include "tests/catch.hpp"
#include "tests/support/earth_terrain.hpp"
#include "tests/support/look_around_checks.hpp"
#include "tests/support/made_grid.hpp"

#include <GeographicLib/Geodesic.hpp>

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace orograph::look_around_test {
namespace {

const std::string kData = std::string(OROGRAPH_SOURCE_DIR) + "/data_samples/";
using Real = long double;

ViewSpec eye_at(GivenPlace place) {
  ViewSpec view;
  view.eye_map = place;
  return view;
}

Skyline skyline_of(const TerrainData& whole, const ViewSpec& view, double step_deg) {
  const TerrainOfView terrain(whole, view);
  const std::vector<BorderEdge> border = border_of(terrain->surface);
  return LookAround(*terrain, border, observer_of(view, *terrain)).skyline(step_deg);
}

std::vector<PlaceSight> sights_of(const TerrainData& whole, const ViewSpec& view,
                                  const std::vector<Vec2>& places, double above_m = 0) {
  const TerrainOfView terrain(whole, view);
  const std::vector<BorderEdge> border = border_of(terrain->surface);
  return LookAround(*terrain, border, observer_of(view, *terrain)).sights(places, above_m);
}

// Hills about 7 E, 46 N; rough, so that the skyline is on other ground in every direction.
double hills_m(double lon_deg, double lat_deg) {
  return 1500 + 400 * std::sin(170 * lon_deg) * std::cos(130 * lat_deg) +
         300 * std::sin(900 * lon_deg + 700 * lat_deg);
}
const DegreeLattice kHills{6.9, 0.005, 41, 46.1, -0.005, 41};

} // namespace

TEST_CASE("Places are seen and hidden as the ray walk has them, on all kinds of terrain") {
  struct Case {
    const char* file;
    bool degrees;
  };
  for (const auto& [file, degrees] :
       {Case{"fractal_alps.tif", false}, Case{"volcano.tif", false}, Case{"jacksboro.tif", true},
        Case{"quarry_points.csv", false}}) {
    const TerrainData terrain = read_terrain({kData + file}, {});
    const Box2 bounds = map_bounds(terrain);
    SightCounts sums;
    for (std::uint64_t seed = 1; seed <= last_seed(4); ++seed) {
      Random random(seed);
      ViewSpec view;
      do {
        view = eye_at(GivenPlace(random.between(bounds.low.x, bounds.high.x),
                                 random.between(bounds.low.y, bounds.high.y)));
        view.eye_height_m = random.pick({2.0, 50.0});
        if (seed % 2 == 0) view.eye_summit_m = 0.1 * (degrees ? 1e5 : 1) * bounds.width();
      } while (!view.eye_summit_m &&
               !ground_at({view.eye_map->x, view.eye_map->y}, terrain)); // in a gap
      view.exaggeration = random.pick({1.0, 1.5});
      view.curvature =
          terrain.map.earth || random.chance(0.5) ? Curvature::automatic : Curvature::off;
      const SightCounts one =
          compare_with_ray_walk(terrain, view, 400, random.pick({0.0, 10.0}), random);
      INFO(file << ", seed " << seed);
      CHECK(one.wrong == 0);
      CHECK(one.unlike == 0);
      CHECK(one.greatest_off_m < 1e-6); // of heights of 1e3 m, by slopes right to 1e-13
      sums.asked += one.asked;
      sums.seen += one.seen;
      sums.hidden += one.hidden;
      sums.ties += one.ties;
    }
    INFO(file);
    CHECK(sums.seen >= enough(20u));
    CHECK(sums.hidden >= enough(200u));
    CHECK(10 * sums.ties <= sums.asked); // vertices of edges that are seen themselves
  }
}

TEST_CASE("The skyline on the ellipsoid is the highest of all triangles, to 1e-9 degrees") {
  const TerrainData terrain = earth_terrain(kHills, hills_m);
  // On a vertex and between; low and high.
  for (const Vec3 eye : {Vec3{7, 46, 3000}, Vec3{7.0013, 46.0021, 1900}, Vec3{6.95, 46.05, 2300}}) {
    ViewSpec view = eye_at(eye);
    const Skyline skyline = skyline_of(terrain, view, 7.5);
    REQUIRE(skyline.directions.size() == 48);
    // Places by GeographicLib, lifted by refraction as the definition says.
    const Vec3 at = local_cartesian_m(eye, {eye.x, eye.y, 0});
    const double sine = std::sin(eye.y * std::numbers::pi / 180);
    const Real e2 = 1 / 298.257223563L * (2 - 1 / 298.257223563L), w2 = 1 - e2 * sine * sine;
    const Real radius_m = 6378137 * std::sqrt(1 - e2) / w2;
    const auto vertex = [&](int column, int row) {
      const double lon = kHills.lon_deg(column), lat = kHills.lat_deg(row);
      const Vec3 p = local_cartesian_m({lon, lat, hills_m(lon, lat)}, {eye.x, eye.y, 0});
      const Real lift = view.refraction * (Real(p.x) * p.x + Real(p.y) * p.y) / (2 * radius_m);
      return std::array<Real, 3>{p.x, p.y, p.z + lift};
    };
    double farthest_m = 0;
    for (const auto& [azimuth_deg, place] : skyline.directions) {
      const Vec2 towards = direction_of_azimuth(Angle::degrees(azimuth_deg));
      Real highest = -std::numeric_limits<Real>::infinity(), distance_m = 0;
      const auto meet = [&](const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
        const auto aside = [&](const auto& p) { return towards.x * p[1] - towards.y * p[0]; };
        const auto along = [&](const auto& p) { return towards.x * p[0] + towards.y * p[1]; };
        if ((aside(a) < 0) == (aside(b) < 0)) return;
        const Real t = aside(a) / (aside(a) - aside(b));
        const Real d = along(a) + t * (along(b) - along(a)), z = a[2] + t * (b[2] - a[2]);
        if (d < 1e-3L || (z - at.z) / d <= highest) return;
        highest = (z - at.z) / d;
        distance_m = d;
      };
      for (int r = 0; r < kHills.rows; ++r)
        for (int c = 0; c < kHills.columns; ++c) {
          const auto here = vertex(c, r);
          if (c + 1 < kHills.columns) meet(here, vertex(c + 1, r));
          if (r + 1 < kHills.rows) meet(here, vertex(c, r + 1));
          if (c + 1 < kHills.columns && r + 1 < kHills.rows) meet(here, vertex(c + 1, r + 1));
        }
      INFO("azimuth " << azimuth_deg << " from " << eye.x << ", " << eye.y << ", " << eye.z);
      REQUIRE(place);
      const Real altitude_deg = std::atan(highest) * 180 / std::numbers::pi_v<Real>;
      CHECK(std::abs(place->bearing.altitude_deg - altitude_deg) < 1e-9L);
      CHECK(place->bearing.azimuth_deg == azimuth_deg);
      // The geodesic is as long as the way on the level, less what the earth curves and is wider
      // where the ground is.
      CHECK(std::abs(place->bearing.distance_m - distance_m) < 1e-3L * distance_m);
      double s12 = 0, azimuth = 0, back = 0;
      REQUIRE(place->lonlat);
      GeographicLib::Geodesic::WGS84().Inverse(eye.y, eye.x, place->lonlat->y, place->lonlat->x,
                                               s12, azimuth, back);
      // Uprights of two places aren't in one plane: of 2 km of height that is 3e-5 degrees.
      CHECK(std::abs(std::remainder(azimuth - azimuth_deg, 360)) < 1e-4);
      CHECK(std::abs(s12 - place->bearing.distance_m) < 1e-3);
      farthest_m = std::max(farthest_m, place->bearing.distance_m);
    }
    REQUIRE(skyline.most_distant);
    CHECK(skyline.most_distant->bearing.distance_m >= farthest_m);
  }
}

TEST_CASE("Summits are in the azimuths and at the distances of geodesics") {
  // In degrees, and in UTM zone 32, 150 km from its middle, where north is aside by more than a
  // degree.
  const TerrainData degrees = earth_terrain(kHills, hills_m);
  TerrainData utm;
  std::vector<double> heights;
  for (int i = 0; i < 101 * 101; ++i) heights.push_back(100 + (i % 7) * 3.0);
  utm.surface = Grid{101, 101, PlaneLattice{{0, 0}, {500, 0}, {0, -500}}, std::move(heights)};
  utm.map.origin = {320000, 5120000};
  utm.map.crs_wkt = utm.map.crs_name = "EPSG:32632";
  utm.map.radii = CurvatureRadii{6370000, 6390000};
  Random random(3);
  for (const TerrainData* terrain : std::initializer_list<const TerrainData*>{&degrees, &utm}) {
    const Box2 bounds = map_bounds(*terrain);
    const Vec2 eye = bounds.centre();
    std::vector<Vec2> summits;
    for (int i = 0; i < 10; ++i)
      summits.push_back({random.between(bounds.low.x, bounds.high.x),
                         random.between(bounds.low.y, bounds.high.y)});
    ViewSpec view = eye_at(GivenPlace(eye.x, eye.y));
    view.eye_height_m = 500;
    const auto lonlat = [&](Vec2 map) { return *lonlat_of_map(terrain->map.crs_wkt, map); };
    const auto sights = sights_of(*terrain, view, summits);
    for (std::size_t i = 0; i < summits.size(); ++i) {
      const Vec2 from = lonlat(eye), to = lonlat(summits[i]);
      double s12 = 0, azimuth = 0, back = 0;
      GeographicLib::Geodesic::WGS84().Inverse(from.y, from.x, to.y, to.x, s12, azimuth, back);
      INFO("summit " << i << ", azimuth " << azimuth << ", " << s12 << " m");
      CHECK(std::abs(std::remainder(sights[i].bearing.azimuth_deg - azimuth, 360)) < 1e-9);
      CHECK(std::abs(sights[i].bearing.distance_m - s12) < 1e-6);
      CHECK((sights[i].state == PlaceState::seen || sights[i].state == PlaceState::hidden));
    }
    // And the skyline's places lie in its directions: on the map a geodesic bends by 0.01 degrees
    // at most, 60 km on.
    for (const auto& [azimuth_deg, place] : skyline_of(*terrain, view, 15).directions) {
      REQUIRE(place);
      const Vec2 from = lonlat(eye);
      double s12 = 0, azimuth = 0, back = 0;
      GeographicLib::Geodesic::WGS84().Inverse(from.y, from.x, place->lonlat->y, place->lonlat->x,
                                               s12, azimuth, back);
      CHECK(std::abs(std::remainder(azimuth - azimuth_deg, 360)) < 0.01);
    }
  }
}

TEST_CASE("What is hidden is seen once it is as much higher") {
  const TerrainData terrain = earth_terrain(kHills, hills_m);
  ViewSpec view = eye_at(GivenPlace(7, 46));
  std::vector<Vec2> places;
  Random random(5);
  for (int i = 0; i < 200; ++i)
    places.push_back({random.between(6.91, 7.09), random.between(45.91, 46.09)});
  const auto sights = sights_of(terrain, view, places);
  int hidden = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (sights[i].state != PlaceState::hidden) continue;
    ++hidden;
    CHECK(sights[i].hidden_m > 0);
    CHECK(sights[i].hidden_deg > 0);
    const double m = sights[i].hidden_m;
    CHECK(sights_of(terrain, view, {places[i]}, m + 1e-6)[0].state == PlaceState::seen);
    CHECK(sights_of(terrain, view, {places[i]}, m * (1 - 1e-6))[0].state == PlaceState::hidden);
  }
  CHECK(hidden > 50);
}

TEST_CASE("Places beside the terrain and in its gaps are told as such") {
  TerrainData terrain;
  std::vector<double> heights(25, 10);
  heights[12] = std::numeric_limits<double>::quiet_NaN();
  terrain.surface = Grid{5, 5, PlaneLattice{{0, 0}, {10, 0}, {0, -10}}, std::move(heights)};
  terrain.map.crs_name = "none";
  const auto sights =
      sights_of(terrain, eye_at(GivenPlace(5, -5)), {{20, -20}, {50, -5}, {35, -35}, {5, -5}});
  CHECK(sights[0].state == PlaceState::gap);
  CHECK(sights[1].state == PlaceState::outside);
  CHECK(sights[2].state == PlaceState::seen);
  CHECK(sights[3].state == PlaceState::seen);
  CHECK(sights[1].bearing.azimuth_deg == 90);
  CHECK(sights[1].bearing.distance_m == 45);
  CHECK(sights[3].bearing.altitude_deg == -90);
}

TEST_CASE("An eye goes to the highest ground about it, as high above it as it was") {
  TerrainData terrain;
  std::vector<double> heights;
  for (int r = 0; r < 21; ++r)
    for (int c = 0; c < 21; ++c) heights.push_back(c == 12 && r == 9 ? 80 : c == 3 ? 90 : 5 + c);
  terrain.surface = Grid{21, 21, PlaneLattice{{0, 0}, {10, 0}, {0, -10}}, std::move(heights)};
  terrain.map.crs_name = "none";
  ViewSpec view = eye_at(GivenPlace(101, -99));
  CHECK_FALSE(eye_move(view, terrain));
  view.eye_summit_m = 50;
  const auto move = eye_move(view, terrain);
  REQUIRE(move);
  CHECK(move->to_map == Vec2{120, -90});
  CHECK(move->to_m == 80);
  CHECK(move->distance_m == Approx(std::hypot(19, 9)).epsilon(1e-12));
  const ViewSpec there = on_summit(view, terrain);
  CHECK(there.eye_map == GivenPlace(120, -90));
  CHECK_FALSE(there.eye_summit_m);
  view.eye_map->z = 115.1; // 100 above the ground, which is 15.1 there
  REQUIRE(on_summit(view, terrain).eye_map->z);
  CHECK(*on_summit(view, terrain).eye_map->z == Approx(180).epsilon(1e-12));
  view.eye_map->z.reset();
  view.eye_summit_m = 75; // the wall of 90 m is in reach: its nearest vertex
  CHECK(eye_move(view, terrain)->to_map == Vec2{30, -100});
  view.eye_summit_m = 0.5; // no vertex is in reach
  CHECK(eye_move(view, terrain)->distance_m == 0);
  view.eye_map = GivenPlace(500, 500);
  CHECK_THROWS_AS(eye_move(view, terrain), Error);
}

TEST_CASE("On the ellipsoid an eye goes to the highest vertex that a geodesic reaches") {
  const TerrainData terrain = earth_terrain(kHills, hills_m);
  for (const double within_m : {700.0, 2500.0}) {
    ViewSpec view = eye_at(GivenPlace(7.0017, 46.0013));
    view.eye_summit_m = within_m;
    Vec2 best{};
    double highest_m = -1;
    for (int r = 0; r < kHills.rows; ++r)
      for (int c = 0; c < kHills.columns; ++c) {
        const double lon = kHills.lon_deg(c), lat = kHills.lat_deg(r);
        double s12 = 0;
        GeographicLib::Geodesic::WGS84().Inverse(46.0013, 7.0017, lat, lon, s12);
        if (s12 > within_m || hills_m(lon, lat) <= highest_m) continue;
        highest_m = hills_m(lon, lat);
        best = {lon, lat};
      }
    const auto move = eye_move(view, terrain);
    REQUIRE(move);
    CHECK(move->to_map == best);
    CHECK(move->to_m == highest_m);
  }
}

} // namespace orograph::look_around_test
