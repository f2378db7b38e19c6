// SPDX-License-Identifier: GPL-3.0-or-later
// Known answers on the ellipsoid: where the drawn sea ends, and which mountains show beyond it.
#include "map/draw_map.hpp"
#include "placing/terrain_of_view.hpp"
#include "tests/catch.hpp"
#include "tests/support/earth_terrain.hpp"

#include <GeographicLib/Geodesic.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orograph::earth_horizon_test {
namespace {

constexpr double kRadian_deg = 180 / std::numbers::pi;
// Of a mountain's limiting distance: a sphere of Euler's radius for the ellipsoid, the parabola of
// refraction with Gauss's radius, K being a share of it.
constexpr double kLimitingShare = 1e-3;
const Ellipsoid kSphere{6371000, 0};

struct Eye {
  double lon_deg, lat_deg, height_m;
};

// Upright over the origin of a frame on an ellipsoid, along a level direction (east, north): how
// the sea lies in it, by the ellipsoid's own equation.
class SeaSection {
public:
  SeaSection(const Ellipsoid& ellipsoid, double lat_deg, Vec2 level) {
    const double a = ellipsoid.semi_major_axis_m, b = a * (1 - ellipsoid.flattening());
    const double s = std::sin(lat_deg / kRadian_deg), c = std::cos(lat_deg / kRadian_deg);
    const double n = a * a / std::hypot(a * c, b * s);
    // Outward over the origin's meridian, east and along the axis; scaled to the unit sphere.
    origin_ = {n * c / a, 0, n * b / a * s / a};
    up_ = {c / a, 0, s / b};
    ahead_ = {-level.y * s / a, level.x / a, level.y * c / b};
  }

  // Height in the frame of the sea at a distance on the level: the upper root of
  // |origin + d ahead + z up| = 1, without cancellation.
  double height_m(double distance_m) const {
    const double p = dot(up_, up_), q = dot(origin_, up_) + distance_m * dot(ahead_, up_);
    const double r =
        distance_m * (2 * dot(origin_, ahead_) + distance_m * dot(ahead_, ahead_)); // |origin| = 1
    return -r / (q + std::sqrt(q * q - p * r));
  }

  // The greatest slope (up over level) at which an eye over the origin sees the sea, lifted by
  // `lift_per_m2` of the distance's square.
  double horizon_slope(double eye_m, double lift_per_m2) const {
    const auto slope = [&](double d) { return (height_m(d) + lift_per_m2 * d * d - eye_m) / d; };
    double low = 0.5 * std::sqrt(2 * eye_m * 6.3e6), high = 4 * low; // rises, then falls
    while (high - low > 1e-5 * low) {
      const double one = low + (high - low) / 3, other = high - (high - low) / 3;
      if (slope(one) < slope(other))
        low = one;
      else
        high = other;
    }
    return slope(0.5 * (low + high));
  }

private:
  Vec3 origin_, up_, ahead_;
};

double lift_per_m2(const Ellipsoid& ellipsoid, double lat_deg, double refraction) {
  return refraction / (2 * mean_radius_m(ellipsoid, lat_deg));
}

// The sea along a geodesic from the eye, in cells of about `cell_m`, with a vertex at its end.
struct SeaStrip {
  DegreeLattice lattice;
  int end_column, end_row;
};
SeaStrip strip_of_sea(const Eye& eye, double azimuth_deg, double length_m, double cell_m,
                      int beyond, const Ellipsoid& ellipsoid) {
  const GeographicLib::Geodesic geodesic(ellipsoid.semi_major_axis_m, ellipsoid.flattening());
  double lat_deg = 0, lon_deg = 0;
  geodesic.Direct(eye.lat_deg, eye.lon_deg, azimuth_deg, length_m, lat_deg, lon_deg);
  lon_deg = eye.lon_deg + std::remainder(lon_deg - eye.lon_deg, 360);
  const double north_deg = cell_m / 6371000 * kRadian_deg;
  const double east_deg = north_deg / std::cos(eye.lat_deg / kRadian_deg);
  // Room beside the line, and a cell or two behind the eye.
  constexpr int kBeside = 5;
  const auto cells = [](double from, double to, double step) {
    return static_cast<int>(std::ceil((to - from) / step));
  };
  SeaStrip strip;
  DegreeLattice& l = strip.lattice;
  l.lon_step_deg = east_deg;
  l.lat_step_deg = -north_deg;
  const double sine = std::sin(azimuth_deg / kRadian_deg),
               cosine = std::cos(azimuth_deg / kRadian_deg);
  const int east_of_end = sine > 0.5 ? beyond : kBeside,
            west_of_end = sine < -0.5 ? beyond : kBeside;
  const int north_of_end = cosine > 0.5 ? beyond : kBeside,
            south_of_end = cosine < -0.5 ? beyond : kBeside;
  const double west = std::min(lon_deg - west_of_end * east_deg, eye.lon_deg - kBeside * east_deg);
  const double east = std::max(lon_deg + east_of_end * east_deg, eye.lon_deg + kBeside * east_deg);
  const double south =
      std::min(lat_deg - south_of_end * north_deg, eye.lat_deg - kBeside * north_deg);
  const double north =
      std::max(lat_deg + north_of_end * north_deg, eye.lat_deg + kBeside * north_deg);
  strip.end_column = cells(west, lon_deg, east_deg);
  strip.end_row = cells(lat_deg, north, north_deg);
  l.first_lon_deg = lon_deg - strip.end_column * east_deg;
  l.first_lat_deg = lat_deg + strip.end_row * north_deg;
  l.columns = strip.end_column + cells(lon_deg, east, east_deg) + 1;
  l.rows = strip.end_row + cells(south, lat_deg, north_deg) + 1;
  return strip;
}

MapSpec looking(const Eye& eye, double azimuth_deg, double dip_deg, double refraction) {
  MapSpec spec;
  spec.view.eye_map = Vec3{eye.lon_deg, eye.lat_deg, eye.height_m};
  spec.view.look_azimuth = Angle::degrees(azimuth_deg);
  spec.view.pitch = Angle::degrees(-dip_deg);
  spec.view.field_of_view = Angle::degrees(2);
  spec.view.curvature = Curvature::on;
  spec.view.refraction = refraction;
  spec.style.simplify_mm = 0;
  spec.style.silhouette_jump = 0;
  spec.style.flat = FlatGround::draw;
  spec.style.plan = ProfileCount{60};
  return spec;
}

// What is drawn, as level directions from the eye (east, north) with the slope there.
struct Seen {
  Vec2 level;
  double slope;
};
struct DrawnLines {
  std::vector<Seen> skyline, profiles;
  double mm_per_slope = 0;
  double skyline_share = 0; ///< of the page's width
};

DrawnLines draw(TerrainData terrain, const MapSpec& spec) {
  stand_on_earth(terrain, spec.view);
  const PlacedView scene = placed_view(terrain, spec);
  REQUIRE(scene.curvature.on_ellipsoid);
  const Map drawn = draw_map(terrain, scene, spec, [](double) {});
  const Homography from_page = inverse(scene.to_page);
  DrawnLines seen;
  seen.mm_per_slope = scene.to_page.mm_per_y({0, 0});
  for (const Layer& layer : drawn.drawing.layers) {
    if (layer.name != "skyline" && layer.name != "profiles") continue;
    for (const Stroke& stroke : layer.strokes) {
      const auto points = layer.points(stroke);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 at = from_page(points[i]);
        const Vec2 level = scene.view.forward + at.x * scene.view.right;
        const double more = length(level);
        (layer.name == "skyline" ? seen.skyline : seen.profiles)
            .push_back({(1 / more) * level, at.y / more});
        if (i > 0 && layer.name == "skyline")
          seen.skyline_share +=
              std::abs(points[i].x - points[i - 1].x) / scene.page.inner_mm().width();
      }
    }
  }
  return seen;
}

// The farthest that a mountain shows from an eye, over a sphere of this radius.
double limiting_distance_m(double radius_m, double eye_m, double mountain_m) {
  return radius_m *
         (std::acos(radius_m / (radius_m + eye_m)) + std::acos(radius_m / (radius_m + mountain_m)));
}

} // namespace

// The surface is the lattice's triangles, whose vertices alone lie on the ellipsoid. Below it they
// are by no more than the square of half a triangle's longest side over 2R, so the horizon, at a
// distance d, is too low by side^2 / 8Rd and never too high. Lines on the page end on a lattice of
// 1e-4 mm.
TEST_CASE("the drawn sea ends at the ellipsoid's horizon, along the meridian and across it",
          "[unsanitized]") {
  double most = 0, greatest_share = 0;
  for (const double lat_deg : {46.0, -70.0, 0.0})
    for (const double azimuth_deg : {0.0, 90.0, 180.0, 270.0})
      for (const double height_m : {2.0, 100.0, 1000.0, 9000.0})
        for (const double refraction : {0.0, 0.13}) {
          const Eye eye{7.3, lat_deg, height_m};
          const double lift = lift_per_m2({}, lat_deg, refraction);
          const double away_m = std::sqrt(2 * 6371000 / (1 - refraction) * height_m);
          const double cell_m = away_m / 100;
          const SeaStrip strip = strip_of_sea(eye, azimuth_deg, 1.15 * away_m, cell_m, 3, {});
          const Vec2 forward = direction_of_azimuth(Angle::degrees(azimuth_deg));
          const double dip_deg =
              -kRadian_deg *
              std::atan(SeaSection({}, lat_deg, forward).horizon_slope(height_m, lift));
          const DrawnLines seen =
              draw(earth_terrain(strip.lattice, [](double, double) { return 0; }),
                   looking(eye, azimuth_deg, dip_deg, refraction));
          CAPTURE(lat_deg, azimuth_deg, height_m, refraction, dip_deg);
          const double page_step = kPageStep_mm / seen.mm_per_slope;
          const double side_m = std::sqrt(2) * 1.01 * cell_m; // cells widen towards the equator
          const double sag = side_m * side_m / (8 * 6.33e6) / away_m;
          REQUIRE(seen.skyline_share > 0.98);
          for (const Seen& at : seen.skyline) {
            const double horizon = SeaSection({}, lat_deg, at.level).horizon_slope(height_m, lift);
            REQUIRE(at.slope <= horizon + page_step);
            REQUIRE(at.slope >= horizon - sag - page_step);
            most = std::max(most, horizon - at.slope);
            greatest_share = std::max(greatest_share, (horizon - at.slope) / -horizon);
          }
          REQUIRE(seen.profiles.size() > 20);
          for (const Seen& at : seen.profiles)
            REQUIRE(at.slope <=
                    SeaSection({}, lat_deg, at.level).horizon_slope(height_m, lift) + page_step);
        }
  WARN("the drawn horizon is at most " << most * kRadian_deg * 3600 << "\" too low, a share of "
                                       << greatest_share << " of its dip");
}

// acos(R / (R + h)) with R = 6371 km: the figure of a sphere. On WGS 84 Euler's radius runs from
// 6335 to 6400 km, and the dip from 3.0522 (along the meridian at the equator) to 3.0369 degrees
// (at the poles); at 46 degrees it is 3.0440 along the meridian and 3.0394 across it.
TEST_CASE("from 9 km the sea's horizon dips by 3.0437 degrees on a sphere") {
  const Eye eye{7.3, 46, 9000};
  const double away_m = std::sqrt(2 * 6371000.0 * 9000), cell_m = away_m / 200;
  const SeaStrip strip = strip_of_sea(eye, 0, 1.15 * away_m, cell_m, 3, kSphere);
  TerrainData terrain = earth_terrain(
      strip.lattice, [](double, double) { return 0; }, kSphere);
  double highest = -1;
  for (const Seen& at : draw(terrain, looking(eye, 0, 3.04, 0)).skyline)
    highest = std::max(highest, at.slope);
  CHECK(std::abs(std::atan(highest) * kRadian_deg + 3.0437) <= 6e-5);
  const auto dip_deg = [](double lat_deg, Vec2 level) {
    return -kRadian_deg * std::atan(SeaSection({}, lat_deg, level).horizon_slope(9000, 0));
  };
  CHECK(-kRadian_deg * std::atan(SeaSection(kSphere, 46, {0, 1}).horizon_slope(9000, 0)) ==
        Approx(std::acos(6371. / 6380) * kRadian_deg).epsilon(1e-9));
  CHECK(dip_deg(0, {0, 1}) == Approx(3.0522).margin(5e-5));
  CHECK(dip_deg(90, {0, 1}) == Approx(3.0369).margin(5e-5));
  CHECK(dip_deg(46, {0, 1}) == Approx(3.0440).margin(5e-5));
  CHECK(dip_deg(46, {1, 0}) == Approx(3.0394).margin(5e-5));
}

TEST_CASE("a mountain shows up to its limiting distance, and is drawn at its place") {
  for (const double lat_deg : {44.0, -65.0})
    for (const double azimuth_deg : {0.0, 90.0, 270.0})
      for (const auto& [eye_m, mountain_m] : {std::pair{2.0, 300.0}, std::pair{100.0, 1500.0}})
        for (const double refraction : {0.0, 0.13}) {
          const Eye eye{-71.3, lat_deg, eye_m};
          // Euler's radius half-way, bent away by refraction.
          const double rough_m = limiting_distance_m(6371000, eye_m, mountain_m);
          const double middle_deg =
              lat_deg + 0.5 * rough_m * std::cos(azimuth_deg / kRadian_deg) / 6371000 * kRadian_deg;
          const double radius_m =
              1 / (1 / euler_radius_m({}, middle_deg, Angle::degrees(azimuth_deg)) -
                   2 * lift_per_m2({}, lat_deg, refraction));
          const double limit_m = limiting_distance_m(radius_m, eye_m, mountain_m);
          for (const double times : {1 - kLimitingShare, 1 + kLimitingShare}) {
            const double away_m = times * limit_m, cell_m = limit_m / 400;
            const SeaStrip strip = strip_of_sea(eye, azimuth_deg, away_m, cell_m, 4, {});
            TerrainData terrain = earth_terrain(strip.lattice, [](double, double) { return 0; });
            Grid& grid = std::get<Grid>(terrain.surface);
            std::get<Heights<double>>(grid.heights_m)
                .own()[grid.index(strip.end_column, strip.end_row)] = mountain_m;
            const double lift = lift_per_m2({}, lat_deg, refraction);
            // The summit by GeographicLib alone.
            const DegreeLattice& l = strip.lattice;
            const Vec3 summit = local_cartesian_m(
                {l.lon_deg(strip.end_column), l.lat_deg(strip.end_row), mountain_m},
                {eye.lon_deg, eye.lat_deg, 0});
            const double level_m = std::hypot(summit.x, summit.y);
            const Vec2 towards{summit.x / level_m, summit.y / level_m};
            const double top = (summit.z + lift * level_m * level_m - eye_m) / level_m;
            const double horizon = SeaSection({}, lat_deg, towards).horizon_slope(eye_m, lift);
            const DrawnLines seen =
                draw(terrain, looking(eye, azimuth_deg, -horizon * kRadian_deg, refraction));
            CAPTURE(lat_deg, azimuth_deg, eye_m, mountain_m, refraction, times, limit_m);
            const double page_step = kPageStep_mm / seen.mm_per_slope;
            double above = -1;
            Vec2 highest;
            for (const Seen& at : seen.skyline) {
              const double more =
                  at.slope - SeaSection({}, lat_deg, at.level).horizon_slope(eye_m, lift);
              if (more > above) highest = at.level;
              above = std::max(above, more);
            }
            if (times > 1) {
              CHECK(top < horizon);
              CHECK(above <= page_step);
            } else {
              CHECK(above > 20 * page_step);
              CHECK(std::abs(above - (top - horizon)) <= page_step);
              CHECK(length(highest - towards) <= 2 * page_step);
            }
          }
        }
}

} // namespace orograph::earth_horizon_test
