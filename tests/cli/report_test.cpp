// SPDX-License-Identifier: GPL-3.0-or-later
// The run report; what it says of places on the earth, and where things are drawn, by
// GeographicLib.
#include "cli/render_settings.hpp"
#include "cli/report/run_report.hpp"
#include "geometry/error.hpp"
#include "map/describe_map.hpp"
#include "placing/terrain_of_view.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"
#include "tests/support/earth_terrain.hpp"
#include "tests/support/random.hpp"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace orograph;
using Json = nlohmann::ordered_json;

namespace {

constexpr int kSize = 25;

// Hills around a place, 2 km across.
TerrainData hills_in_degrees(Random& random, double lon_deg, double lat_deg) {
  const double north_deg = 0.0008;
  const double east_deg = north_deg / cos(Angle::degrees(lat_deg));
  const double phase = random.between(0, 6);
  return earth_terrain({lon_deg - 0.5 * (kSize - 1) * east_deg, east_deg, kSize,
                        lat_deg + 0.5 * (kSize - 1) * north_deg, -north_deg, kSize},
                       [&](double lon, double lat) {
                         return 500 + 100 * std::sin(4000 * lat + phase) + 5e4 * (lon - lon_deg) +
                                random.whole(0, 20);
                       });
}

TerrainData hills_in_utm(Random& random, double lon_deg, double lat_deg) {
  TerrainData terrain;
  Grid grid{kSize, kSize, PlaneLattice{{}, {80, 0}, {0, -80}}, {}};
  std::vector<double> heights;
  for (std::size_t i = 0; i < grid.size(); ++i) heights.push_back(random.between(0, 300));
  grid.heights_m = heights;
  terrain.surface = grid;
  double easting = 0, northing = 0;
  GeographicLib::TransverseMercator::UTM().Forward(9, lat_deg, lon_deg, easting, northing);
  terrain.map.origin = {500000 + easting - 40 * kSize, northing + 40 * kSize};
  terrain.map.crs_wkt = "EPSG:32632";
  terrain.map.crs_name = "UTM";
  terrain.map.radii = CurvatureRadii{6.37e6, 6.38e6};
  return terrain;
}

struct Run {
  Json view;
  Drawing drawing;
};
Run run_of(TerrainData& terrain, const MapSpec& spec) {
  const TerrainOfView of_view(terrain, spec.view);
  const PlacedView scene = placed_view(of_view, spec);
  Map drawn = draw_map(*of_view, scene, spec, [](double) {});
  describe_map(drawn, of_view, scene, spec);
  return {Json::parse(report_text(run_report(drawn, {})))["view"], std::move(drawn.drawing)};
}

double turned_apart_deg(double one_deg, double other_deg) {
  return std::abs(std::remainder(one_deg - other_deg, 360));
}

} // namespace

TEST_CASE("a report's words and values") {
  RunReport report;
  report.input.paths = {"a.tif", "b.tif"};
  report.view.projection = "perspective";
  report.view.eye = Vec3{1, 2, 3};
  report.view.homography.m = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  report.profiles = {.spacing = "0.6mm", .depths_m = {10, 20.5}};
  report.counts.strokes = 7;
  report.seconds.read = 0.25;
  report.libraries = {{"gdal", "3.6.2"}};
  report.error_budget.simplification_mm = 0.02;
  report.error_budget.rounding_mm = 0.001;
  const Json json = Json::parse(report_text(report));
  CHECK(json["schema"] == 1);
  CHECK(json["input"]["paths"] == Json{"a.tif", "b.tif"});
  CHECK(json["program"]["name"] == "orograph");
  CHECK(json["program"].contains("commit"));
  CHECK(json["view"]["eye"] == Json({1, 2, 3}));
  CHECK(json["view"]["homography"] == Json({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
  CHECK(json["view"]["exaggeration_auto"] == false);
  CHECK(json["profiles"]["count"] == 2);
  CHECK(json["profiles"]["depths"] == Json({10, 20.5}));
  CHECK(json["counts"]["strokes"] == 7);
  CHECK(json["seconds"]["read"] == 0.25);
  CHECK(json["libraries"]["gdal"] == "3.6.2");
  // The sum of two decimal numbers, to rounding.
  CHECK(std::abs(json["error_budget_mm"]["total"].get<double>() - 0.021) < 1e-15);
  CHECK(report_text(report).starts_with("{\n  \"schema\": 1,\n"));
}

TEST_CASE("what isn't known is null, or unknown, and never 0") {
  RunReport report;
  report.error_budget.level_of_detail_mm.reset();
  const Json json = Json::parse(report_text(report));
  CHECK(json["view"]["eye"].is_null());
  CHECK(json["view"]["distance_m"].is_null());
  CHECK(json["seconds"]["clip"].is_null());
  CHECK(json["error_budget_mm"]["level_of_detail"] == "unknown");
  CHECK(json["error_budget_mm"]["total"] == "unknown");
}

TEST_CASE("a path that isn't UTF-8 still gives JSON") {
  RunReport report;
  report.input.paths = {"caf\xe9.tif"};
  CHECK(Json::accept(report_text(report)));
}

TEST_CASE("a report is written whole, and over another only when told") {
  const MadeFolder folder;
  const std::string path = folder.write("r.json", "old");
  CHECK_THROWS_AS(write_report({}, path, false), Error);
  CHECK(folder.read("r.json") == "old");
  write_report({}, path, true);
  CHECK(folder.read("r.json") == report_text({}));
  CHECK_THROWS_AS(write_report({}, folder.path("nowhere/r.json"), true), Error);
  CHECK(folder.names() == std::vector<std::string>{"r.json"});
}

TEST_CASE("distance and azimuth of the report are the geodesic's, of degrees and of UTM") {
  Random random(1);
  double most_m = 0, most_deg = 0;
  for (int i = 0; i < 200; ++i) {
    const bool in_utm = i % 2 == 1;
    const double lat_deg = in_utm ? random.between(30, 70) : random.between(-80, 80);
    const double lon_deg = in_utm ? random.between(6, 12) : random.between(-180, 180);
    TerrainData terrain = in_utm ? hills_in_utm(random, lon_deg, lat_deg)
                                 : hills_in_degrees(random, lon_deg, lat_deg);
    const auto& geodesic = GeographicLib::Geodesic::WGS84();
    double eye_lat = 0, eye_lon = 0;
    geodesic.Direct(lat_deg, lon_deg, random.between(-180, 180),
                    random.pick({3e3, 5e4, 2e5}) * random.between(0.7, 1), eye_lat, eye_lon);
    MapSpec spec;
    spec.view.eye_lonlat = Vec3{eye_lon, eye_lat, 4000};
    const double target_lon = lon_deg + random.between(-0.01, 0.01);
    const double target_lat = lat_deg + random.between(-0.005, 0.005);
    spec.view.look_at_lonlat = Vec3{target_lon, target_lat, random.between(0, 500)};
    spec.style.layers = {"border"};
    const Json view = run_of(terrain, spec).view;
    double distance_m = 0, azimuth_deg = 0, there_deg = 0;
    geodesic.Inverse(eye_lat, eye_lon, target_lat, target_lon, distance_m, azimuth_deg, there_deg);
    const double off_m = std::abs(view["geodesic"]["distance_m"].get<double>() - distance_m);
    const double off_deg =
        turned_apart_deg(view["geodesic"]["azimuth_deg"].get<double>(), azimuth_deg);
    CAPTURE(i, in_utm, lon_deg, lat_deg, eye_lon, eye_lat, view.dump());
    REQUIRE(off_m <= 1e-5);
    REQUIRE(off_deg <= 1e-7);
    // The straight line in space is the chord, or the map plane's.
    CHECK(view["distance_m"].get<double>() > 0.98 * distance_m);
    most_m = std::max(most_m, off_m);
    most_deg = std::max(most_deg, off_deg);
    for (const char* name : {"eye_lonlat", "look_at_lonlat"}) {
      const Vec3 asked = name == std::string("eye_lonlat") ? Vec3{eye_lon, eye_lat, 4000}
                                                           : Vec3{target_lon, target_lat, 0};
      CHECK(turned_apart_deg(view[name][0].get<double>(), asked.x) <= 1e-9);
      CHECK(std::abs(view[name][1].get<double>() - asked.y) <= 1e-9);
    }
  }
  WARN("of 200 eyes at most " << most_m << " m and " << most_deg << " degrees off");
}

TEST_CASE("the azimuth that is asked for is the report's, from true north, up to 80 degrees") {
  Random random(2);
  for (double lat_deg = -80; lat_deg <= 80; lat_deg += 4)
    for (const bool on_ground : {true, false}) {
      const double lon_deg = random.between(-180, 360), asked_deg = random.between(0, 360);
      TerrainData terrain = hills_in_degrees(random, lon_deg, lat_deg);
      MapSpec spec;
      spec.view.eye_lonlat = GivenPlace(lon_deg, lat_deg);
      if (!on_ground) spec.view.eye_lonlat->z = 2500;
      spec.view.look_azimuth = Angle::degrees(asked_deg);
      spec.view.pitch = Angle::degrees(-20);
      spec.view.field_of_view = Angle::degrees(60);
      spec.style.layers = {"border"};
      const Json view = run_of(terrain, spec).view;
      CAPTURE(lat_deg, lon_deg, asked_deg);
      CHECK(turned_apart_deg(view["look_azimuth_true_deg"].get<double>(), asked_deg) <= 1e-7);
      CHECK(turned_apart_deg(view["look_azimuth_deg"].get<double>(), asked_deg) <= 1e-9);
      // The meridian through the eye is the frame's north.
      const double east = view["forward"][0].get<double>(),
                   north = view["forward"][1].get<double>();
      CHECK(std::abs(east - sin(Angle::degrees(asked_deg))) <= 1e-12);
      CHECK(std::abs(north - cos(Angle::degrees(asked_deg))) <= 1e-12);
    }
}

// The page place of a vertex from the report alone: LocalCartesian about the report's eye, its
// forward and its homography, refraction by its coefficient.
TEST_CASE("vertices are drawn where LocalCartesian has them, within 1 mm on the ground") {
  Random random(3);
  double most_mm = 0;
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    const double lat_deg = random.between(-85, 85), lon_deg = random.between(-180, 180);
    TerrainData terrain = hills_in_degrees(random, lon_deg, lat_deg);
    const TerrainData as_read = terrain;
    MapSpec spec;
    double eye_lat = 0, eye_lon = 0;
    GeographicLib::Geodesic::WGS84().Direct(lat_deg, lon_deg, random.between(-180, 180),
                                            random.pick({1500., 2500., 6e4}), eye_lat, eye_lon);
    const bool far = i % 3 == 2;
    spec.view.eye_lonlat = Vec3{eye_lon, eye_lat, far ? 6000.0 : 1400.0};
    spec.view.look_at_lonlat = Vec3{lon_deg, lat_deg, 500};
    spec.view.field_of_view = Angle::degrees(random.between(5, 60));
    spec.view.exaggeration = random.pick({1.0, 2.0});
    spec.view.roll = Angle::degrees(random.pick({0.0, 17.0}));
    spec.view.curvature = Curvature::on;
    spec.view.refraction = random.pick({0.0, 0.13, 0.5});
    spec.style.layers = {"edges"};
    spec.style.simplify_mm = 0;
    spec.ground_points = true;
    const Run run = run_of(terrain, spec);

    const Vec3 eye{run.view["eye"][0], run.view["eye"][1], run.view["eye"][2]};
    const Vec2 forward{run.view["forward"][0], run.view["forward"][1]};
    const double k = run.view["exaggeration"];
    const double lift =
        run.view["curvature"]["refraction"].get<double>() / (2 * mean_radius_m({}, eye.y));
    Homography to_page;
    for (std::size_t n = 0; n < 9; ++n) to_page.m[n] = run.view["homography"][n / 3][n % 3];
    const auto on_page = [&](Vec3 frame_m) {
      const double u = frame_m.x * forward.y - frame_m.y * forward.x;
      const double v = frame_m.x * forward.x + frame_m.y * forward.y;
      return to_page.at({u, frame_m.z + lift * (u * u + v * v) - k * eye.z, v});
    };
    CAPTURE(i, lon_deg, lat_deg, spec.view.refraction, k, eye.x, eye.y, eye.z);
    const Grid& grid = std::get<Grid>(as_read.surface);
    const DegreeLattice& lattice = grid.earth().degrees();
    const Layer& edges = run.drawing.layers.front();
    for (const Stroke& stroke : edges.strokes)
      for (std::uint32_t n = stroke.first_point + 1;
           n + 1 < stroke.first_point + stroke.point_count; ++n) { // where edges meet
        const Vec3 map = edges.map[n];
        const auto column =
            static_cast<int>(std::lround((map.x - lattice.first_lon_deg) / lattice.lon_step_deg));
        const auto row =
            static_cast<int>(std::lround((map.y - lattice.first_lat_deg) / lattice.lat_step_deg));
        REQUIRE(std::abs(map.x - lattice.lon_deg(column)) <= 1e-9);
        const Vec3 vertex = local_cartesian_m(
            {lattice.lon_deg(column), lattice.lat_deg(row), k * grid.height_m(column, row)}, eye);
        const Vec2 expected = on_page(vertex);
        constexpr double kMillimetre_m = 1e-3;
        const double allowed_mm =
            std::max(length(on_page(vertex + Vec3{0, 0, kMillimetre_m}) - expected),
                     length(on_page(vertex + kMillimetre_m * Vec3{forward.y, -forward.x, 0}) -
                            expected)) +
            kPageStep_mm / std::sqrt(2);
        const double off_mm = length(edges.page_mm[n] - expected);
        REQUIRE(off_mm <= allowed_mm);
        most_mm = std::max(most_mm, off_mm);
        ++compared;
      }
  }
  WARN(compared << " drawn vertices at most " << most_mm << " mm off on the page");
  CHECK(compared > 2000);
}
