// SPDX-License-Identifier: GPL-3.0-or-later
// The same ground, eye and target in two CRSs, on a map plane that bends and on the ellipsoid, give
// the same picture.
#include "dem/read/lonlat.hpp"
#include "map/draw_map.hpp"
#include "map/error_budget.hpp"
#include "map/line_on_page.hpp"
#include "placing/terrain_of_view.hpp"
#include "tests/catch.hpp"
#include "tests/support/earth_terrain.hpp"

#include <GeographicLib/TransverseMercator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace orograph::two_crs_test {
namespace {

constexpr double kRadian_deg = 180 / std::numbers::pi;
constexpr double kSteps_m = 50; // of both grids, about
// 110 km from the middle of UTM zone 32, where north is a degree off the map's.
constexpr double kEyeLon_deg = 10.4, kEyeLat_deg = 46.5;
constexpr double kFalseEasting_m = 500000, kMiddle_deg = 9;

// Kilometres east and north of the eye, near enough; what matters is that both grids have the same.
struct Km {
  double x, y;
};
constexpr double kDegree_km = 111.2;
Km km_of(double lon_deg, double lat_deg) {
  return {(lon_deg - kEyeLon_deg) * kDegree_km * std::cos(kEyeLat_deg / kRadian_deg),
          (lat_deg - kEyeLat_deg) * kDegree_km};
}
Vec2 lonlat_of(Km at) {
  return {kEyeLon_deg + at.x / kDegree_km / std::cos(kEyeLat_deg / kRadian_deg),
          kEyeLat_deg + at.y / kDegree_km};
}

double hill(Km at, Km centre, double height_m, double width_km) {
  const double x = (at.x - centre.x) / width_km, y = (at.y - centre.y) / width_km;
  return height_m * std::exp(-0.5 * (x * x + y * y));
}
// A crest of some length through its centre, blunt over 300 m only.
double crest(Km at, Km centre, double height_m, double turn_deg, double long_km, double wide_km) {
  constexpr double kBlunt_km = 0.3;
  const double s = std::sin(turn_deg / kRadian_deg), c = std::cos(turn_deg / kRadian_deg);
  const double along = ((at.x - centre.x) * c + (at.y - centre.y) * s) / long_km;
  const double across = (at.y - centre.y) * c - (at.x - centre.x) * s;
  const double from_crest = std::hypot(across, kBlunt_km) - kBlunt_km;
  return height_m * std::exp(-0.5 * along * along - from_crest / wide_km);
}

// A plain, hills from 12 km on, and a ridge right across 30 km away, behind which nothing shows.
constexpr double kNearestHill_km = 10;
double height_m(double lon_deg, double lat_deg) {
  const Km at = km_of(lon_deg, lat_deg);
  return 150 + hill(at, {-3, 14}, 700, 1.1) + hill(at, {5, 17}, 950, 1.5) +
         crest(at, {1.5, 20}, 1200, 25, 2.5, 1.8) + crest(at, {-5, 24}, 1700, -35, 2, 2.2) +
         crest(at, {0, 30}, 1500, 3, 40, 2.5) + hill(at, {6, 30}, 600, 2) +
         crest(at, {-1, 29}, 500, 70, 2, 1.5);
}
constexpr Km kLow{-12, -1}, kHigh{12, 35};

TerrainData in_degrees() {
  const double north_deg = kSteps_m / 1000 / kDegree_km;
  const double east_deg = north_deg / std::cos(kEyeLat_deg / kRadian_deg);
  const Vec2 first = lonlat_of({kLow.x, kHigh.y});
  const int columns = static_cast<int>((kHigh.x - kLow.x) * 1000 / kSteps_m) + 1;
  const int rows = static_cast<int>((kHigh.y - kLow.y) * 1000 / kSteps_m) + 1;
  return earth_terrain({first.x, east_deg, columns, first.y, -north_deg, rows}, height_m);
}

// The heights at its vertices by GeographicLib's projection, the rest of the run by PROJ's.
TerrainData in_utm() {
  const auto& utm = GeographicLib::TransverseMercator::UTM();
  const auto map_of = [&](Km at) {
    Vec2 map;
    const Vec2 lonlat = lonlat_of(at);
    utm.Forward(kMiddle_deg, lonlat.y, lonlat.x, map.x, map.y);
    return Vec2{map.x + kFalseEasting_m, map.y};
  };
  Box2 box;
  for (const Km corner : {kLow, Km{kLow.x, kHigh.y}, Km{kHigh.x, kLow.y}, kHigh})
    box.include(map_of(corner));
  TerrainData terrain;
  Grid grid;
  grid.columns = static_cast<int>(box.width() / kSteps_m) + 1;
  grid.rows = static_cast<int>(box.height() / kSteps_m) + 1;
  grid.lattice = PlaneLattice{{}, {kSteps_m, 0}, {0, -kSteps_m}};
  terrain.map.origin = {box.low.x, box.high.y};
  terrain.map.crs_wkt = "EPSG:32632";
  terrain.map.crs_name = "UTM";
  terrain.map.radii = CurvatureRadii{euler_radius_m({}, kEyeLat_deg, Angle()),
                                     euler_radius_m({}, kEyeLat_deg, Angle::degrees(90))};
  std::vector<double> heights;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      double lat_deg = 0, lon_deg = 0;
      utm.Reverse(kMiddle_deg, terrain.map.origin.x + column * kSteps_m - kFalseEasting_m,
                  terrain.map.origin.y - row * kSteps_m, lat_deg, lon_deg);
      heights.push_back(height_m(lon_deg, lat_deg));
    }
  grid.heights_m = std::move(heights);
  terrain.surface = std::move(grid);
  return terrain;
}

// At a place, or in a direction: then the picture doesn't follow what curvature does to the place.
MapSpec settings_of(bool at_target) {
  MapSpec spec;
  spec.view.eye_lonlat = Vec3{kEyeLon_deg, kEyeLat_deg, 600};
  if (at_target) {
    const Vec2 target = lonlat_of({0, 25});
    spec.view.look_at_lonlat = Vec3{target.x, target.y, 900};
  } else {
    spec.view.look_azimuth = Angle::degrees(1);
    spec.view.pitch = Angle::degrees(0.5);
  }
  spec.view.curvature = Curvature::on;
  spec.style.simplify_mm = 0;
  spec.style.silhouette_jump = 0;
  spec.style.plan = ProfileCount{80};
  return spec;
}

struct Picture {
  PlacedView scene;
  ErrorBudget budget;
  std::vector<double>
      top_mm; ///< of all ink, in columns of kColumn_mm; infinite where there is none
};
constexpr double kColumn_mm = 0.02;

std::vector<double> top_of_ink(const Drawing& drawing) {
  std::vector<double> top(static_cast<std::size_t>(drawing.page.width_mm / kColumn_mm) + 1,
                          std::numeric_limits<double>::infinity());
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes) {
      const auto points = layer.points(stroke);
      for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec2 a = points[i - 1].x < points[i].x ? points[i - 1] : points[i];
        const Vec2 b = points[i - 1].x < points[i].x ? points[i] : points[i - 1];
        for (auto c = static_cast<std::size_t>(std::ceil(a.x / kColumn_mm));
             static_cast<double>(c) * kColumn_mm <= b.x; ++c) {
          const double share =
              b.x > a.x ? (static_cast<double>(c) * kColumn_mm - a.x) / (b.x - a.x) : 0;
          top[c] = std::min(top[c], a.y + share * (b.y - a.y));
        }
      }
    }
  return top;
}

Picture picture_of(TerrainData& terrain, const MapSpec& spec) {
  stand_on_earth(terrain, spec.view);
  Picture picture;
  picture.scene = placed_view(terrain, spec);
  REQUIRE(picture.scene.curvature.applied);
  picture.budget = error_budget(terrain, picture.scene, spec, std::nullopt);
  const Map drawn = draw_map(terrain, picture.scene, spec, [](double) {});
  picture.top_mm = top_of_ink(drawn.drawing);
  return picture;
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(p - a, along) / square, 0., 1.) : 0;
  return length(p - (a + share * along));
}

// The greatest distance of one skyline from the other. Skylines are graphs, joined upright where a
// hill ends in front of a farther one.
double farthest_mm(const std::vector<double>& one, const std::vector<double>& other) {
  constexpr int kAside = 50; // columns: a millimetre
  const int count = static_cast<int>(one.size());
  const auto at = [](const std::vector<double>& top, int i) {
    return Vec2{i * kColumn_mm, top[static_cast<std::size_t>(i)]};
  };
  double farthest = 0;
  for (int i = 0; i < count; ++i) {
    const Vec2 p = at(one, i);
    if (!std::isfinite(p.y)) continue;
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = std::max(i - kAside, 0); k < std::min(i + kAside, count - 1); ++k)
      if (std::isfinite(at(other, k).y) && std::isfinite(at(other, k + 1).y))
        nearest = std::min(nearest, distance_to_segment(p, at(other, k), at(other, k + 1)));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

// The surface's greatest second derivative over the hills, per metre, for each metre of distance
// from the eye: along east, north and half-way, at places that are nearer to each other than the
// crests are blunt.
double greatest_bend() {
  constexpr double kStep_km = 0.05;
  double greatest = 0;
  for (double y = kNearestHill_km; y <= kHigh.y; y += 2 * kStep_km)
    for (double x = kLow.x; x <= kHigh.x; x += 2 * kStep_km)
      for (const Km step : {Km{1, 0}, Km{0, 1}, Km{0.7071, 0.7071}, Km{0.7071, -0.7071}}) {
        const auto h = [&](double k) {
          const Vec2 at = lonlat_of({x + k * kStep_km * step.x, y + k * kStep_km * step.y});
          return height_m(at.x, at.y);
        };
        greatest =
            std::max(greatest, std::abs(h(1) - 2 * h(0) + h(-1)) / (1000 * std::hypot(x, y)));
      }
  return greatest / (kStep_km * kStep_km * 1e6);
}

} // namespace

// What may part the two skylines, in mm:
// - sampling: within a triangle a surface that bends by at most B leaves the plane through the
//   vertices by B * side^2 / 8, side the longest; each grid by its own, and at the hills' distance
//   or farther (the plain before them is far below the skyline);
// - the map plane's turns and stretches, the parabola, and edges that stay straight where vertices
//   sink: the run's own error budget, `geodesy`;
// - refraction, K d^2 / 2R, with Euler's radius here and Gauss's there, 0.34 % apart at most;
// - the page's step.
TEST_CASE("a UTM grid and a degrees grid of one surface have the same skyline and landmarks",
          "[unsanitized]") {
  const bool at_target = GENERATE(true, false);
  TerrainData utm = in_utm(), degrees = in_degrees();
  const MapSpec spec = settings_of(at_target);
  const Picture plane = picture_of(utm, spec), earth = picture_of(degrees, spec);
  REQUIRE_FALSE(plane.scene.curvature.on_ellipsoid);
  REQUIRE(earth.scene.curvature.on_ellipsoid);

  // PROJ and GeographicLib mean the same UTM.
  const Vec2 corner = lonlat_of_map("EPSG:32632", utm.map.origin).value();
  double easting = 0, northing = 0;
  GeographicLib::TransverseMercator::UTM().Forward(kMiddle_deg, corner.y, corner.x, easting,
                                                   northing);
  CHECK(std::hypot(easting + kFalseEasting_m - utm.map.origin.x, northing - utm.map.origin.y) <=
        1e-4);

  double mm_per_radian = 0; // of what is on the page, at most
  for (const double x : {-0.27, 0.0, 0.27})
    for (const double y : {-0.1, 0.1})
      mm_per_radian =
          std::max(mm_per_radian, plane.scene.to_page.mm_per_step({x, y, 1}, {1, 0, 0}));
  const double side_m = 1.01 * std::sqrt(2) * kSteps_m;
  const double sampling_mm = 2 * mm_per_radian * 1.1 * greatest_bend() * side_m * side_m / 8;
  REQUIRE(plane.budget.geodesy_mm);
  REQUIRE(earth.budget.geodesy_mm);
  const double geodesy_mm = *plane.budget.geodesy_mm + *earth.budget.geodesy_mm;
  const double refraction_mm = mm_per_radian * 0.13 * 0.0034 * kHigh.y * 1000 / (2 * 6.37e6);
  const double bound_mm = sampling_mm + geodesy_mm + refraction_mm + 2 * kPageStep_mm;

  // All of the page's width has a skyline.
  for (const Picture* picture : {&plane, &earth})
    REQUIRE(kColumn_mm *
                static_cast<double>(std::count_if(picture->top_mm.begin(), picture->top_mm.end(),
                                                  [](double y) { return std::isfinite(y); })) >
            0.999 * picture->scene.page.inner_mm().width());
  const double apart_mm =
      std::max(farthest_mm(plane.top_mm, earth.top_mm), farthest_mm(earth.top_mm, plane.top_mm));
  WARN("skylines " << apart_mm << " mm apart; bound " << bound_mm << " mm: sampling " << sampling_mm
                   << ", geodesy " << geodesy_mm << ", refraction " << refraction_mm);
  CHECK(bound_mm < 0.2);
  CHECK(apart_mm <= bound_mm);

  double landmarks_mm = 0;
  constexpr std::array kLandmarks{Km{-3, 14}, Km{5, 17},  Km{1.5, 20}, Km{-5, 24}, Km{0, 30},
                                  Km{6, 30},  Km{-1, 29}, Km{-7, 31},  Km{2, 12},  Km{8, 33}};
  for (const Km km : kLandmarks) {
    const Vec2 at = lonlat_of(km);
    const double height = height_m(at.x, at.y);
    const Vec2 map = map_of_lonlat(utm.map.crs_wkt, at).value();
    const auto on_page = [&](const Picture& picture, Vec3 ground_m) {
      return page_mm(to_profile_frame(picture.scene.view, ground_m), picture.scene.view,
                     picture.scene.to_page);
    };
    const Vec2 on_plane = on_page(plane, utm.map.to_ground_m({map.x, map.y, height}));
    const Vec2 on_earth =
        on_page(earth, local_cartesian_m({at.x, at.y, height}, {kEyeLon_deg, kEyeLat_deg, 0}));
    landmarks_mm = std::max(landmarks_mm, length(on_plane - on_earth));
  }
  WARN("landmarks " << landmarks_mm << " mm apart; bound " << geodesy_mm + refraction_mm << " mm");
  CHECK(landmarks_mm <= geodesy_mm + refraction_mm);
  CHECK(landmarks_mm > 0); // not the same scene twice
}

} // namespace orograph::two_crs_test
