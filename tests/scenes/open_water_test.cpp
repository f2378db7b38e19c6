// SPDX-License-Identifier: GPL-3.0-or-later
// Where water runs out of the data nothing is drawn, but to an eye near it, whose horizon it is.
#include "dem/approximate/tin_of_grid.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace orograph::open_water_test {
namespace {

constexpr int kSide = 41;
constexpr double kCell_m = 50, kEnd_m = kCell_m * (kSide - 1);

// Islands in a sea at height 0 that reaches all of the border but what `coast` says: the westmost
// columns are land then.
TerrainData islands(Random& random, bool coast, bool as_tin) {
  Grid grid{kSide, kSide, PlaneLattice{{0, kEnd_m}, {kCell_m, 0}, {0, -kCell_m}},
            std::vector<float>(static_cast<std::size_t>(kSide) * kSide, 0.0F)};
  std::vector<float> heights(grid.size(), 0.0F);
  for (int hill = 0; hill < 3; ++hill) {
    const double east = random.between(14, 27), north = random.between(14, 27);
    for (int r = 0; r < kSide; ++r)
      for (int c = 0; c < kSide; ++c)
        heights[grid.index(c, r)] =
            std::max(heights[grid.index(c, r)],
                     static_cast<float>(200 - 25 * std::hypot(c - east, r - north)));
  }
  if (coast)
    for (int r = 0; r < kSide; ++r)
      for (int c = 0; c < 4; ++c)
        heights[grid.index(c, r)] = static_cast<float>(10 * (4 - c) + random.between(0, 3));
  grid.heights_m = heights;
  TerrainData terrain;
  if (as_tin)
    terrain.surface = tin_of(grid);
  else
    terrain.surface = grid;
  return terrain;
}

MapSpec on_the_ground() {
  MapSpec spec;
  spec.ground_points = true;
  spec.style.plan = ProfileCount{20};
  spec.style.simplify_mm = 0;
  spec.style.light.reset();
  spec.view.curvature = Curvature::off;
  return spec;
}

Map drawn(const TerrainData& terrain, const MapSpec& spec) {
  return draw_map(terrain, placed_view(terrain, spec), spec, [](double) {});
}

bool is_on_border(Vec3 p) {
  constexpr double kNear_m = 1e-6;
  return std::min(p.x, p.y) < kNear_m || std::max(p.x, p.y) > kEnd_m - kNear_m;
}

// Metres of the DEM's border that layers of lines draw, and of that the part at sea level; the
// steepest sight down to that, and how much it rises or falls with azimuth, in radians.
struct Border {
  double land_m = 0, sea_m = 0, steepest = 0, greatest_rise = 0;
  bool before_water = false; ///< somewhere the sea lies behind it, seen from the eye
};

Border border_of(const Map& map, Vec3 eye = {}) {
  Border found;
  for (const Layer& layer : map.drawing.layers) {
    if (layer.name != "border" && layer.name != "skyline") continue;
    for (const Stroke& stroke : layer.strokes)
      for (std::uint32_t i = stroke.first_point + 1; i < stroke.first_point + stroke.point_count;
           ++i) {
        const Vec3 a = layer.map[i - 1], b = layer.map[i];
        if (!is_on_border(a) || !is_on_border(b) || !is_on_border(0.5 * (a + b))) continue;
        const double along_m = length(b - a);
        const bool is_sea = std::max(std::abs(a.z), std::abs(b.z)) < 1e-6;
        (is_sea ? found.sea_m : found.land_m) += along_m;
        if (!is_sea) continue;
        const Vec3 middle = 0.5 * (a + b);
        const Vec3 nearer = middle + (1 / length(eye - middle)) * (eye - middle);
        found.before_water |=
            std::min(nearer.x, nearer.y) < 0 || std::max(nearer.x, nearer.y) > kEnd_m;
        const auto drop = [&](Vec3 p) {
          return std::atan2(eye.z - p.z, std::hypot(p.x - eye.x, p.y - eye.y));
        };
        const auto azimuth = [&](Vec3 p) { return std::atan2(p.x - eye.x, p.y - eye.y); };
        found.steepest = std::max({found.steepest, drop(a), drop(b)});
        const double turn = std::abs(std::remainder(azimuth(a) - azimuth(b), 2 * std::numbers::pi));
        if (along_m > 1)
          found.greatest_rise = std::max(found.greatest_rise, std::abs(drop(a) - drop(b)) / turn);
      }
  }
  return found;
}

double length_of(const Map& map, const std::string& name) {
  double sum = 0;
  for (const Layer& layer : map.drawing.layers)
    if (layer.name == name)
      for (const Stroke& stroke : layer.strokes) sum += line_length_mm(layer.points(stroke));
  return sum;
}

} // namespace

TEST_CASE("water that runs out of a framed picture has no border, and land has") {
  for (std::uint64_t seed = 1; seed <= last_seed(40); ++seed) {
    Random random(seed);
    const bool coast = seed % 2 == 0, as_tin = seed % 3 == 0;
    const TerrainData terrain = islands(random, coast, as_tin);
    MapSpec spec = on_the_ground();
    spec.view.from_azimuth = Angle::degrees(random.between(0, 360));
    const double elevation_deg = random.between(1, 60);
    spec.view.from_elevation = Angle::degrees(elevation_deg);
    if (seed % 4 == 0) spec.view.projection = Projection::orthographic;
    INFO("seed " << seed);
    const Border one = border_of(drawn(terrain, spec));
    CHECK(one.sea_m == 0);
    spec.style.outline = Outline::by_layer;
    const Border by_layer = border_of(drawn(terrain, spec));
    CHECK(by_layer.sea_m > kEnd_m);
    CHECK(one.land_m == Approx(by_layer.land_m));
    if (coast && elevation_deg > 20) CHECK(one.land_m > kEnd_m / 4);
    spec.style.outline = Outline::one;
    spec.style.flat = FlatGround::draw;
    CHECK(border_of(drawn(terrain, spec)).sea_m > kEnd_m);
  }
}

TEST_CASE("a lake that the data cuts has the land's border") {
  constexpr int kFine = 201;
  const auto sea_m = [&](int lake_cells) {
    std::vector<float> heights;
    for (int r = 0; r < kFine; ++r)
      for (int c = 0; c < kFine; ++c) {
        const bool is_lake = r >= 60 && r <= 60 + lake_cells && c < 60; // large enough for water
        heights.push_back(is_lake ? 0.0F : static_cast<float>(20 + (7 * r + 5 * c) % 11));
      }
    constexpr double kFine_m = kEnd_m / (kFine - 1);
    TerrainData terrain;
    terrain.surface = Grid{kFine, kFine, PlaneLattice{{0, kEnd_m}, {kFine_m, 0}, {0, -kFine_m}},
                           std::move(heights)};
    MapSpec spec = on_the_ground();
    spec.view.from_azimuth = Angle::degrees(270); // the lake's border is the nearest
    return border_of(drawn(terrain, spec)).sea_m;
  };
  CHECK(sea_m(15) == Approx(150)); // of 800 edges
  CHECK(sea_m(17) == 0);
}

TEST_CASE("to an eye in the landscape water ends at its horizon, or nowhere") {
  double horizon_m = 0;
  std::size_t none = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    Random random(seed);
    const TerrainData terrain = islands(random, seed % 2 == 0, seed % 3 == 0);
    MapSpec spec = on_the_ground();
    const Vec3 eye{random.between(-500, 2500), random.between(-500, 300),
                   random.pick({5.0, 20.0, 60.0, 300.0})};
    spec.view.eye_map = eye;
    spec.view.look_at_map = Vec3{random.between(0, kEnd_m), kEnd_m, 0};
    spec.view.field_of_view = Angle::degrees(70);
    INFO("seed " << seed);
    const Border found = border_of(drawn(terrain, spec), eye);
    CHECK_FALSE(found.before_water);
    CHECK(found.steepest <= 2.01 * std::numbers::pi / 180);
    CHECK(found.greatest_rise <= 0.12); // 0.1 over a cell, of which this may be a part
    horizon_m += found.sea_m;
    none += found.sea_m == 0 ? 1U : 0U;
  }
  CHECK(horizon_m > enough(20) * kEnd_m / 40);
  CHECK(none > enough(10));
}

TEST_CASE("water without a shore has its border") {
  Grid grid{kSide, kSide, PlaneLattice{{0, kEnd_m}, {kCell_m, 0}, {0, -kCell_m}},
            std::vector<float>(static_cast<std::size_t>(kSide) * kSide, 5.0F)};
  TerrainData terrain;
  terrain.surface = grid;
  CHECK(length_of(drawn(terrain, on_the_ground()), "border") +
            length_of(drawn(terrain, on_the_ground()), "skyline") >
        100);
}

TEST_CASE("shores are drawn whether water is or not, and alike") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    const TerrainData terrain = islands(random, seed % 2 == 0, seed % 3 == 0);
    MapSpec spec = on_the_ground();
    spec.view.from_azimuth = Angle::degrees(random.between(0, 360));
    spec.ground_points = seed % 2 == 0;
    INFO("seed " << seed);
    const Map shore = drawn(terrain, spec);
    spec.style.flat = FlatGround::draw;
    const Map draw = drawn(terrain, spec);
    CHECK(length_of(shore, "shores") > 50);
    CHECK(length_of(draw, "shores") == length_of(shore, "shores"));
    CHECK(length_of(draw, "profiles") > 1.2 * length_of(shore, "profiles"));
  }
}

} // namespace orograph::open_water_test
