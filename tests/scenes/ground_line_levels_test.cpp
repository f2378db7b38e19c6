// SPDX-License-Identifier: GPL-3.0-or-later
// Which heights have contours; where meridians, parallels and a mesh's lines are; what strokes say
// of themselves.
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/read/lonlat.hpp"
#include "geometry/error.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "map/draw_map.hpp"
#include "placing/contours.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace orograph::ground_line_levels_test {
namespace {

// 40 x 30 vertices, 1 km apart, in UTM zone 32; heights 100 to 2000.
TerrainData terrain_of(Random& random) {
  TerrainData terrain;
  GridLattice lattice{40, 30};
  lattice.column_step_m = {1000, 30};
  lattice.row_step_m = {30, -1000};
  Grid grid = made_grid(random, lattice, {.low = 100, .high = 2000});
  const auto heights = std::get<Heights<float>>(grid.heights_m).own();
  heights[0] = 100;
  heights[1] = 2000;
  terrain.surface = std::move(grid);
  terrain.map.crs_wkt = "EPSG:32632";
  terrain.map.origin = {600000, 5200000};
  return terrain;
}

ContourLevels levels(const TerrainData& terrain, const ContourSpec& spec) {
  return contour_levels(terrain, spec);
}

} // namespace

TEST_CASE("contours are at whole intervals, or where a list says, in the unit asked for") {
  Random random(1);
  TerrainData terrain = terrain_of(random);
  const ContourLevels every = levels(terrain, {.interval = 300, .unit_m = 1});
  CHECK(every.heights_m == std::vector<double>{300, 600, 900, 1200, 1500, 1800});
  CHECK(every.is_index == std::vector<bool>{false, false, false, false, true, false});
  // The greatest height has ground below it, the least has none.
  CHECK(levels(terrain, {.interval = 950, .offset = 100, .unit_m = 1}).heights ==
        std::vector<double>{1050, 2000});
  const ContourLevels below = levels(terrain, {.interval = 500, .offset = -400, .unit_m = 1});
  CHECK(below.heights == std::vector<double>{600, 1100, 1600});
  const ContourLevels feet = levels(terrain, {.interval = 1000, .unit_m = 0.3048});
  CHECK(feet.heights == std::vector<double>{1000, 2000, 3000, 4000, 5000, 6000});
  CHECK(feet.heights_m[1] == 2000 * 0.3048);
  terrain.map.height_unit_m = 0.3048;
  CHECK(levels(terrain, {.interval = 1000}).heights_m == feet.heights_m);
  CHECK(levels(terrain, {.levels = {-5, 400, 1500, 9000}, .unit_m = 1}).heights ==
        std::vector<double>{400, 1500});
  CHECK(levels(terrain, {.interval = 5000, .unit_m = 1}).heights.empty());
  CHECK_THROWS_AS(levels(terrain, {.interval = 1e-6, .unit_m = 1}), Error);
}

TEST_CASE("contours nobody chose are 1, 2 or 5 times a power of ten apart, some 25 of them") {
  for (double value = 0.003; value < 3e5; value *= 1.07) {
    const double step = round_step(value);
    INFO(value << " " << step);
    const double mantissa = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
    CHECK(std::min({std::abs(mantissa - 1), std::abs(mantissa - 2), std::abs(mantissa - 5)}) <
          1e-9);
    CHECK(std::max(step / value, value / step) < 1.6); // the root of 2.5
  }
  Random random(2);
  const std::size_t count = levels(terrain_of(random), {}).heights.size();
  CHECK(count > 15);
  CHECK(count < 41);
}

TEST_CASE("contours nobody chose are fewer where ground is steep on a large map") {
  // Ridges 20 km apart whose sides rise by 0.1, with voids between: of a map 250 mm wide, contours
  // are to be 180 m apart or more where it shows 1,000 km, and 9 m where it shows 50.
  const auto ridges = [](int columns) {
    GridLattice lattice{columns, 12};
    lattice.column_step_m = {1000, 0};
    lattice.row_step_m = {0, -1000};
    Random random(4);
    TerrainData terrain;
    Grid grid = made_grid(random, lattice, {.low = 0, .high = 1});
    const auto heights = std::get<Heights<float>>(grid.heights_m).own();
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const int column = static_cast<int>(i) % columns;
      heights[i] = column % 37 == 36 ? std::numeric_limits<float>::quiet_NaN()
                                     : 100.0F * static_cast<float>(std::abs(column % 20 - 10));
    }
    terrain.surface = std::move(grid);
    return terrain;
  };
  const auto as_tin = [](TerrainData terrain) {
    const Grid grid = std::get<Grid>(terrain.surface);
    terrain.surface = tin_of(grid);
    return terrain;
  };
  const TerrainData country = ridges(1001), district = ridges(51);
  CHECK(levels(country, {}).heights == std::vector<double>{200, 400, 600, 800, 1000});
  CHECK(levels(as_tin(country), {}).heights == std::vector<double>{200, 400, 600, 800, 1000});
  CHECK(levels(country, {.unit_m = 0.3048}).heights ==
        std::vector<double>{500, 1000, 1500, 2000, 2500, 3000});
  CHECK(levels(district, {}).heights.size() == 20);
  CHECK(levels(as_tin(district), {}).heights.size() == 20);
  CHECK(levels(country, {.interval = 40}).heights.size() == 25);
}

TEST_CASE(
    "meridians, parallels, eastings and a mesh's lines are where PROJ and the map have them") {
  Random random(3);
  const TerrainData terrain = terrain_of(random);
  MapSpec spec;
  spec.style.layers = {"graticule", "grid", "mesh"};
  spec.style.mesh.spacing_m = 2500;
  spec.style.graticule_deg = 0.05;
  spec.style.grid_m = 4000;
  const PlacedView placed = placed_view(terrain, spec);
  const GroundLines lines = ground_lines_of(terrain, placed, spec.style);
  const auto first_point = static_cast<std::uint32_t>(vertex_count(terrain.surface));
  std::set<std::string> seen;
  for (const GroundLine& line : lines.lines) {
    const auto& [kind, attributes, is_tick, width_mm] = lines.features[line.feature];
    const std::string& name = attributes.front().name;
    const double level = std::get<double>(attributes.front().value);
    seen.insert(name);
    if (line.ends.to < first_point) continue;
    const ProfilePoint at = lines.points[line.ends.to - first_point];
    const Vec3 on_map = terrain.map.to_map(to_ground_m(placed.view, at));
    if (kind == LineKind::graticule) {
      const Vec2 lonlat = lonlat_of_map(terrain.map.crs_wkt, {on_map.x, on_map.y}).value();
      // Cells of a kilometre: 16 of them bend by 4 m or so, 5e-5 degrees.
      REQUIRE(std::abs((name == "longitude" ? lonlat.x : lonlat.y) - level) < 1e-4);
      REQUIRE(level == std::round(level / 0.05) * 0.05);
    } else {
      const bool is_x = name == "x" || name == "easting";
      REQUIRE(std::abs((is_x ? on_map.x : on_map.y) - level) < 1e-5);
      const double step = kind == LineKind::grid ? 4000 : 2500;
      REQUIRE(level == std::round(level / step) * step);
    }
  }
  CHECK(seen == std::set<std::string>{"easting", "latitude", "longitude", "northing", "x", "y"});
}

TEST_CASE("strokes of contours and draped lines tell what they are lines of") {
  Random random(4);
  const TerrainData terrain = terrain_of(random);
  MapSpec spec;
  spec.ground_points = true;
  spec.style.layers = {"contours", "drape"};
  spec.style.contours.interval = 100;
  PlacedView placed = placed_view(terrain, spec);
  Overlay overlay;
  overlay.places = {{605000, 5195000}, {625000, 5180000}};
  overlay.lines = {{0, 2}};
  overlay.features = {{{{"name", std::string("way")}}, 0, 1}};
  placed.overlays = std::span(&overlay, 1);
  const Map map = draw_map(terrain, placed, spec, {});
  std::size_t told = 0;
  for (const Layer& layer : map.drawing.layers)
    for (const Stroke& stroke : layer.strokes) {
      REQUIRE(stroke.feature >= 0);
      const Attribute& attribute =
          layer.features.at(static_cast<std::size_t>(stroke.feature)).front();
      ++told;
      if (layer.name == "drape") {
        CHECK(attribute == Attribute{"name", std::string("way")});
        continue;
      }
      const double elevation = std::get<double>(attribute.value);
      CHECK((std::fmod(elevation, 500) == 0) == (layer.name == "index-contours"));
      for (std::uint32_t i = 0; i < stroke.point_count; ++i)
        REQUIRE(std::abs(layer.map[stroke.first_point + i].z - elevation) < 1e-9);
    }
  CHECK(told > 100);
  CHECK(map.facts.counts.draped == 1);
}

TEST_CASE("of many features each is draped as it is alone, in their order") {
  Random random(5);
  const TerrainData terrain = terrain_of(random);
  MapSpec spec;
  PlacedView placed = placed_view(terrain, spec);
  // Several tasks' work, some of it beside the terrain, and points.
  std::vector<Overlay> overlays(2), each;
  for (Overlay& overlay : overlays)
    for (std::int64_t i = 0; i < 25; ++i) {
      Overlay one;
      Vec2 at{random.between(590000, 640000), random.between(5170000, 5200000)};
      const int count = i % 5 == 0 ? 1 : random.whole(500, 1500);
      for (int k = 0; k < count; ++k) {
        one.places.push_back(at);
        at = at + Vec2{random.between(-200, 200), random.between(-200, 200)};
      }
      one.lines = {{0, one.places.size()}};
      one.features = {{{{"number", i}}, 0, 1}};
      overlay.features.push_back({{{"number", i}}, overlay.lines.size(), 1});
      overlay.lines.push_back({overlay.places.size(), one.places.size()});
      overlay.places.insert(overlay.places.end(), one.places.begin(), one.places.end());
      each.push_back(one);
    }
  const auto draped = [&](std::span<const Overlay> which) {
    GroundLines out;
    placed.overlays = which;
    add_overlays(terrain, placed, 0, out);
    return out;
  };
  const GroundLines all = draped(overlays);
  const std::size_t vertices = vertex_count(terrain.surface);
  const auto end_of = [&](const GroundLines& lines, std::uint32_t number) {
    const ProfilePoint p = lines.points.at(number - vertices);
    return Vec3{p.u, p.v, p.z};
  };
  std::size_t at = 0, feature = 0, in_part = 0, beside = 0;
  for (const Overlay& one : each) {
    const GroundLines alone = draped(std::span(&one, 1));
    in_part += alone.draped_in_part;
    beside += alone.not_draped;
    if (alone.features.empty()) continue;
    REQUIRE(feature < all.features.size());
    CHECK(all.features[feature].attributes == one.features[0].attributes);
    std::size_t different = 0;
    for (const GroundLine& line : alone.lines) {
      REQUIRE(at < all.lines.size());
      const GroundLine& other = all.lines[at++];
      different += other.triangle != line.triangle || other.feature != feature ||
                   end_of(all, other.ends.from) != end_of(alone, line.ends.from) ||
                   end_of(all, other.ends.to) != end_of(alone, line.ends.to);
    }
    CHECK(different == 0);
    ++feature;
  }
  CHECK(at == all.lines.size());
  CHECK(feature == all.features.size());
  CHECK(all.draped_in_part == in_part);
  CHECK(all.not_draped == beside);
  CHECK(beside > 0);
  CHECK(feature > 30);
}

} // namespace orograph::ground_line_levels_test
