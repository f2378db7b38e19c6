// SPDX-License-Identifier: GPL-3.0-or-later
// Eye and target from what a user names, on a plane whose heights are known without a grid.
#include "cli/options/named_fields.hpp"
#include "dem/extent.hpp"
#include "dem/read/lonlat.hpp"
#include "geometry/error.hpp"
#include "placing/placed_view.hpp"
#include "placing/places.hpp"
#include "tests/catch.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <limits>

using namespace orograph;

namespace {

constexpr double kFoot_m = 0.3048;

// 100 m in the origin of the ground frame, rising to the north-east; a hole in the middle.
double plane_m(Vec2 ground) {
  return 100 + 0.25 * ground.x + 0.125 * ground.y;
}

// 21 x 21 vertices, 20 m apart, from (0, -400) to (400, 0) in the ground frame.
TerrainData plane_in(const std::string& crs, Vec2 origin) {
  TerrainData terrain;
  std::vector<double> heights;
  for (int row = 0; row < 21; ++row)
    for (int column = 0; column < 21; ++column)
      heights.push_back(row == 10 && column == 10 ? std::numeric_limits<double>::quiet_NaN()
                                                  : plane_m({20.0 * column, -20.0 * row}));
  terrain.surface = Grid{21, 21, PlaneLattice{{0, 0}, {20, 0}, {0, -20}}, std::move(heights)};
  terrain.map.origin = origin;
  terrain.map.crs_wkt = crs;
  terrain.map.crs_name = crs.empty() ? "none" : crs;
  return terrain;
}

ViewRequest placed(const TerrainData& terrain, const MapSpec& spec, double exaggeration = 1) {
  ViewRequest request;
  request.exaggeration = exaggeration;
  place_eye(request, spec.view, terrain);
  return request;
}

void check_no_place(const TerrainData& terrain, const MapSpec& spec,
                    const std::vector<std::string>& words) {
  std::string message;
  try {
    placed(terrain, spec);
  } catch (const Error& error) {
    message = with_options(error.what());
  }
  INFO("message: " << message);
  for (const std::string& word : words) {
    INFO("should say: " << word);
    CHECK(message.find(word) != std::string::npos);
  }
  CHECK(message.find('\n') == std::string::npos);
}

const Vec2 kInUtm{500000, 5205164};

MapSpec eye_at(double x, double y) {
  MapSpec spec;
  spec.view.eye_map = GivenPlace(x, y);
  return spec;
}

MapSpec eye_lonlat(double longitude, double latitude) {
  MapSpec spec;
  spec.view.eye_lonlat = GivenPlace(longitude, latitude);
  return spec;
}

} // namespace

TEST_CASE("without a height the eye is above the ground, and the target on it") {
  TerrainData terrain = plane_in("EPSG:32632", kInUtm);
  terrain.map.unit_m = kFoot_m;
  terrain.map.height_unit_m = 10; // of heights that are given, and of no others
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const Vec2 eye{random.between(0, 150), random.between(-400, 0)},
        target{random.between(250, 400), random.between(-400, 0)};
    MapSpec s = eye_at(kInUtm.x + eye.x / kFoot_m, kInUtm.y + eye.y / kFoot_m);
    s.view.look_at_map = GivenPlace(kInUtm.x + target.x / kFoot_m, kInUtm.y + target.y / kFoot_m);
    const double above = random.pick({2.0, 0.5, 300.0}), k = random.pick({1.0, 1.5, 4.0});
    if (above != 2) s.view.eye_height_m = above;
    const ViewRequest request = placed(terrain, s, k);
    CHECK(length(request.eye_m.value() - Vec3{eye.x, eye.y, plane_m(eye) + above / k}) <= 1e-8);
    CHECK(length(request.look_at_m.value() - Vec3{target.x, target.y, plane_m(target)}) <= 1e-8);
    CHECK_FALSE(request.look);
  }
}

TEST_CASE("heights that are given are the file's, there or elsewhere") {
  TerrainData terrain = plane_in("", kInUtm);
  terrain.map.height_unit_m = kFoot_m;
  MapSpec s;
  s.view.eye_map = Vec3{kInUtm.x - 5000, kInUtm.y, 1000};
  s.view.look_at_map = Vec3{kInUtm.x + 200, kInUtm.y - 200, -10};
  const ViewRequest request = placed(terrain, s, 3);
  CHECK(length(request.eye_m.value() - Vec3{-5000, 0, 1000 * kFoot_m}) <= 1e-9);
  CHECK(length(request.look_at_m.value() - Vec3{200, -200, -10 * kFoot_m}) <= 1e-9);
}

TEST_CASE("by longitude and latitude the same as by the map's coordinates") {
  const TerrainData terrain = plane_in("EPSG:32632", kInUtm);
  const Vec2 eye{50, -300}, target{350, -20};
  const auto lonlat = [&](Vec2 p) {
    return lonlat_of_map(terrain.map.crs_wkt, {kInUtm.x + p.x, kInUtm.y + p.y}).value();
  };
  MapSpec s = eye_lonlat(lonlat(eye).x, lonlat(eye).y);
  s.view.look_at_lonlat = Vec3{lonlat(target).x + 360, lonlat(target).y, 77};
  const ViewRequest request = placed(terrain, s);
  CHECK(length(request.eye_m.value() - Vec3{eye.x, eye.y, plane_m(eye) + 2}) <= 1e-6);
  CHECK(length(request.look_at_m.value() - Vec3{target.x, target.y, 77}) <= 1e-6);
}

TEST_CASE("a direction counts from true north where the CRS tells it") {
  const auto direction = [](const std::string& crs, Vec2 origin) {
    MapSpec s = eye_at(origin.x + 50, origin.y - 50);
    s.view.look_azimuth = Angle::degrees(90);
    s.view.pitch = Angle::degrees(-4);
    const ViewRequest request = placed(plane_in(crs, origin), s);
    REQUIRE(request.look);
    CHECK(request.look->pitch == Angle::degrees(-4));
    CHECK_FALSE(request.look_at_m);
    return request.look->azimuth;
  };
  CHECK(direction("", kInUtm) == Angle::degrees(90));
  CHECK(direction("LOCAL_CS[\"a quarry\",UNIT[\"metre\",1]]", kInUtm) == Angle::degrees(90));
  // On a polar plane the meridian of longitude L leaves downwards, turned by L.
  const Vec2 pole{2000000, 2000000};
  const Angle found = direction("EPSG:32661", pole + Vec2{-50 + 3e5, 50 - 4e5});
  const double longitude = std::atan2(3.0, 4.0) * 180 / 3.14159265358979;
  CHECK(std::abs(found.in_degrees() - (90 - longitude)) <= 1e-7);
}

TEST_CASE("where the ground isn't known, a height is asked for") {
  const TerrainData terrain = plane_in("EPSG:32632", kInUtm);
  check_no_place(terrain, eye_at(3, 4),
                 {"--eye 3,4 is outside of the terrain",
                  "between 500000,5204764 and 500400,5205164", "--eye X,Y,Z"});
  check_no_place(terrain, eye_at(kInUtm.x + 200, kInUtm.y - 200), {"a gap there", "--eye X,Y,Z"});
  check_no_place(terrain, eye_lonlat(9.01, 47),
                 {"--eye-lonlat 9.01,47 is outside", "longitudes 9.00000 and 9.005",
                  "latitudes 46.996", "--eye-lonlat LON,LAT,H"});
  MapSpec target = eye_at(kInUtm.x, kInUtm.y);
  target.view.look_at_lonlat = GivenPlace(9.002, 48);
  check_no_place(terrain, target, {"--look-at-lonlat 9.002,48 is outside", "longitudes"});
  target.view.look_at_lonlat.reset();
  target.view.look_at_map = GivenPlace(3, 4);
  check_no_place(terrain, target, {"--look-at 3,4 is outside", "--look-at X,Y,Z"});
  target.view.look_at_map->z = 5;
  CHECK(placed(terrain, target).look_at_m);
}

TEST_CASE("longitude and latitude need a CRS on the earth, and the right order") {
  check_no_place(plane_in("", kInUtm), eye_lonlat(9, 47),
                 {"--eye-lonlat: the terrain has no CRS", "give --eye X,Y"});
  check_no_place(plane_in("LOCAL_CS[\"a quarry\",UNIT[\"metre\",1]]", kInUtm), eye_lonlat(9, 47),
                 {"--eye-lonlat", "doesn't tell where on the earth it is", "give --eye X,Y"});
  const TerrainData terrain = plane_in("EPSG:32632", kInUtm);
  check_no_place(terrain, eye_lonlat(-81, 3), {"--eye-lonlat -81,3 has no place"});
  MapSpec swapped = eye_lonlat(46.998, 9.002);
  check_no_place(terrain, swapped,
                 {"far from the terrain, which holds 9.002,46.998", "--eye-lonlat 9.002,46.998"});
  swapped.view.eye_lonlat->z = 5000; // needs no ground, and is wrong all the same
  check_no_place(terrain, swapped, {"longitude comes first"});
}

TEST_CASE("an eye in a corner of a wide terrain is in it, however far from its middle") {
  TerrainData terrain = plane_in("EPSG:6933", {0, 0}); // 6000 km wide, from the equator down
  std::get<Grid>(terrain.surface).plane() = {{0, 0}, {300e3, 0}, {0, -150e3}};
  MapSpec spec;
  spec.view.eye_lonlat = GivenPlace(60, -23); // 3900 km from its middle
  const Vec3 eye = *placed(terrain, spec).eye_m;
  CHECK(eye.x == Approx(5789e3).epsilon(1e-3));
  CHECK(eye.y == Approx(-2858e3).epsilon(1e-3));
  spec.view.eye_lonlat = GivenPlace(100, -23); // 3900 km east of it
  check_no_place(terrain, spec, {"km away from the terrain", "longitudes 0.0"});
}

TEST_CASE("from an eye that is given, in whatever way, heights are true") {
  MapSpec s;
  const Box3 low_hills{{0, 0, 0}, {1000, 1000, 10}};
  CHECK(exaggeration_of(s.view, low_hills) == 2);
  s.view.eye_lonlat = GivenPlace(9, 47);
  CHECK(exaggeration_of(s.view, low_hills) == 1);
  s.view.exaggeration = 3;
  CHECK(exaggeration_of(s.view, low_hills) == 3);
}
