// SPDX-License-Identifier: GPL-3.0-or-later
// Hachures run down the slope, are as far apart on the page as asked for, and get heavier with it.
#include "data_samples/terrains.hpp"
#include "map/draw_map.hpp"
#include "placing/hachures.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

namespace orograph::hachures_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kStep_m = 4;
constexpr int kCells = 400;

// About the middle of a grid whose cells are far smaller than what heights change over.
TerrainData terrain_of(const std::function<double(Vec2)>& height_m) {
  TerrainData terrain;
  Grid& grid = grid_of(terrain);
  grid.columns = grid.rows = kCells + 1;
  const double half_m = 0.5 * kCells * kStep_m;
  grid.plane() = {{-half_m, half_m}, {kStep_m, 0}, {0, -kStep_m}};
  std::vector<double> heights;
  for (int row = 0; row <= kCells; ++row)
    for (int column = 0; column <= kCells; ++column)
      heights.push_back(height_m(grid.plane().position_m(column, row)));
  grid.heights_m = Heights<double>(std::move(heights));
  return terrain;
}

// A hill that is wider one way: the steepest descent isn't away from its top.
constexpr double kWide_m = 700, kNarrow_m = 400, kHigh_m = 500;
double hill_m(Vec2 at) {
  const double x = at.x / kWide_m, y = at.y / kNarrow_m;
  return kHigh_m * std::exp(-x * x - y * y);
}
Vec2 rise_of_hill(Vec2 at) {
  const double z = hill_m(at);
  return {-2 * at.x / (kWide_m * kWide_m) * z, -2 * at.y / (kNarrow_m * kNarrow_m) * z};
}

MapSpec seen_from(double elevation_deg, Projection projection) {
  MapSpec spec;
  spec.view.projection = projection;
  spec.view.from_azimuth = Angle::degrees(200);
  spec.view.from_elevation = Angle::degrees(elevation_deg);
  spec.view.exaggeration = 1;
  spec.style.light.reset();
  spec.style.layers.emplace_back("hachures");
  return spec;
}

} // namespace

TEST_CASE("hachures run down the slope within a degree", "[unsanitized]") {
  const TerrainData terrain = terrain_of(hill_m);
  for (const double elevation_deg : {90.0, 40.0, 15.0}) {
    const MapSpec spec = seen_from(elevation_deg, elevation_deg == 40 ? Projection::perspective
                                                                      : Projection::orthographic);
    const PlacedView placed = placed_view(terrain, spec);
    const auto runs = hachures(terrain.surface, placed, spec.style.hachures, 0.15);
    REQUIRE(runs.size() > 100);
    const View& view = placed.view;
    std::size_t asked = 0;
    double worst_deg = 0, worst_width_mm = 0;
    const double inside_m = 0.5 * kCells * kStep_m - 30; // where means have all they are made of
    for (const HachureRun& run : runs) {
      double slope_deg = 0;
      for (std::size_t i = 1; i < run.places.size(); ++i) {
        const Vec2 way = run.places[i] - run.places[i - 1],
                   middle = 0.5 * (run.places[i] + run.places[i - 1]);
        const Vec2 at = view.depth_origin_m + middle.x * view.right + middle.y * view.forward;
        const Vec2 rise = rise_of_hill(at);
        slope_deg += std::atan(plain_length(rise)) / kDegree;
        if (std::max(std::abs(at.x), std::abs(at.y)) > inside_m) continue;
        const Vec2 down = -1.0 * Vec2{dot(rise, view.right), dot(rise, view.forward)};
        const double off_deg = std::abs(std::atan2(cross(way, down), dot(way, down))) / kDegree;
        worst_deg = std::max(worst_deg, off_deg);
        ++asked;
      }
      slope_deg /= static_cast<double>(run.places.size() - 1);
      worst_width_mm =
          std::max(worst_width_mm,
                   std::abs(run.width_mm - hachure_width_mm(spec.style.hachures, 0.15, slope_deg)));
    }
    INFO("from " << elevation_deg << " degrees: " << asked << " asked, worst " << worst_deg
                 << " degrees, " << worst_width_mm << " mm");
    CHECK(asked > 5000);
    CHECK(worst_deg < 1);
    CHECK(worst_width_mm < 0.04); // a step of the widest
  }
}

TEST_CASE("hachures are about as far apart as asked for, wherever the page shows a slope",
          "[unsanitized]") {
  const TerrainData terrain = terrain_of(hill_m);
  for (const double elevation_deg : {90.0, 40.0}) {
    const MapSpec spec = seen_from(elevation_deg, Projection::orthographic);
    const double spacing_mm = spec.style.hachures.spacing_mm;
    const PlacedView placed = placed_view(terrain, spec);
    const Map map = draw_map(terrain, placed, spec, [](double) {});
    CHECK(!find_fault(map.drawing).has_value());
    const auto layer = std::ranges::find(map.drawing.layers, "hachures", &Layer::name);
    REQUIRE(layer != map.drawing.layers.end());
    const View& view = placed.view;
    const auto on_page = [&](Vec2 at) {
      const Vec3 image = placed.on_page(to_profile_frame(view, {at.x, at.y, hill_m(at)}));
      return Vec2{image.x / image.z, image.y / image.z};
    };
    // The gap across a point, in spacings, from line to line.
    Random random(1);
    std::vector<double> gaps;
    constexpr double kMost = 5;
    const double inside_m = 0.5 * kCells * kStep_m - 60;
    while (gaps.size() < 600) {
      const Vec2 at{random.between(-inside_m, inside_m), random.between(-inside_m, inside_m)};
      const Vec2 rise = rise_of_hill(at);
      const double slope_deg = std::atan(plain_length(rise)) / kDegree;
      const Vec2 eye = -1.0 * view.forward;
      const bool faces = dot(eye, rise) < 0.7 * std::tan(elevation_deg * kDegree);
      if (slope_deg < spec.style.hachures.from_deg + 1 || (elevation_deg < 90 && !faces)) continue;
      const Vec2 here = on_page(at), below = on_page(at - (1 / plain_length(rise)) * rise);
      const Vec2 along = (1 / plain_length(below - here)) * (below - here);
      const Vec2 across{-along.y, along.x};
      double left = -kMost * spacing_mm, right = kMost * spacing_mm;
      for (const Stroke& stroke : layer->strokes) {
        const auto points = layer->points(stroke);
        for (std::size_t i = 1; i < points.size(); ++i) {
          const Vec2 a = points[i - 1] - here, b = points[i] - here;
          const double s_a = dot(a, along), s_b = dot(b, along);
          if ((s_a < 0) == (s_b < 0)) continue;
          const double place =
              dot(a, across) + s_a / (s_a - s_b) * (dot(b, across) - dot(a, across));
          if (place < 0)
            left = std::max(left, place);
          else
            right = std::min(right, place);
        }
      }
      gaps.push_back((right - left) / spacing_mm);
    }
    std::ranges::sort(gaps);
    const auto even = std::ranges::count_if(gaps, [](double g) { return g >= 0.5 && g <= 1.6; });
    const double share = static_cast<double>(even) / static_cast<double>(gaps.size());
    WARN("from " << elevation_deg << ": " << 100 * share << " % of gaps within 0.5 to 1.6; 5 % "
                 << gaps[gaps.size() / 20] << ", 50 % " << gaps[gaps.size() / 2] << ", 95 % "
                 << gaps[gaps.size() * 19 / 20]);
    CHECK(share > 0.9);
    CHECK(gaps[gaps.size() / 2] > 0.8);
    CHECK(gaps[gaps.size() / 2] < 1.25);
  }
}

TEST_CASE("ground that is too gentle, or turned away, has no hachures") {
  const MapSpec spec = seen_from(15, Projection::orthographic);
  const auto count = [&](const TerrainData& terrain, MapSpec asked) {
    const PlacedView placed = placed_view(terrain, asked);
    return hachures(terrain.surface, placed, asked.style.hachures, 0.15).size();
  };
  const auto rising = [](double slope_deg) {
    return terrain_of([=](Vec2 at) { return std::tan(slope_deg * kDegree) * at.y; });
  };
  CHECK(count(rising(4.9), spec) == 0);
  CHECK(count(rising(5.1), spec) > 0);
  CHECK(count(terrain_of([](Vec2) { return 3.0; }), spec) == 0);
  CHECK(count(rising(-10), spec) > 0); // falls away from the eye, 5 degrees less than its ray
  CHECK(count(rising(-20), spec) == 0);
  MapSpec steep = spec;
  steep.view.exaggeration = 3; // of the picture; slopes are the ground's own
  CHECK(count(rising(4.9), steep) == 0);
}

TEST_CASE("a hachure's width is from half the pen to half the spacing") {
  const HachureSpec spec;
  CHECK(hachure_width_mm(spec, 0.15, 5) == Approx(0.075));
  CHECK(hachure_width_mm(spec, 0.15, 25) == Approx(0.5 * (0.075 + 0.4)));
  CHECK(hachure_width_mm(spec, 0.15, 45) == Approx(0.4));
  CHECK(hachure_width_mm(spec, 0.15, 80) == Approx(0.4));
}

} // namespace orograph::hachures_test
