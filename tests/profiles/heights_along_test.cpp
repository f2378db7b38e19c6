// SPDX-License-Identifier: GPL-3.0-or-later
// Heights along a profile that isn't cut, beside those of the cut, which knows every triangle.
#include "profiles/cut_surface.hpp"
#include "profiles/heights_along.hpp"
#include "profiles/outline.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace orograph::heights_along_test {
namespace {

Grid random_grid(Random& random) {
  const int columns = random.whole(2, 30), rows = random.whole(2, 30);
  const double angle = random.between(0, 6.28), size = random.between(0.5, 40);
  const Vec2 column{size * std::cos(angle), size * std::sin(angle)};
  const double shear = random.between(-0.3, 0.3), tall = random.between(0.5, 2);
  const Vec2 row = tall * (Vec2{column.y, -column.x} + shear * column);
  std::vector<float> heights;
  for (int i = 0; i < columns * rows; ++i)
    heights.push_back(random.chance(0.05) ? std::numeric_limits<float>::quiet_NaN()
                                          : static_cast<float>(random.whole(0, 50)));
  return {columns, rows,
          PlaneLattice{{random.between(-50, 50), random.between(-50, 50)}, column, row},
          Heights<float>(std::move(heights))};
}

} // namespace

TEST_CASE("heights along a profile are those of its cut") {
  std::size_t compared = 0, without_ground = 0, level_count = 0, at_edges = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    Random random(seed);
    const Surface surface = random_grid(random);
    const Grid& grid = std::get<Grid>(surface);
    TriangleSet level(grid_triangle_count(grid));
    for (std::size_t i = 0; i < grid_triangle_count(grid); ++i)
      if (random.chance(0.2)) level.add(i);
    View view;
    view.projection = Projection::orthographic;
    const double azimuth = random.between(0, 6.28);
    view.forward = {std::sin(azimuth), std::cos(azimuth)};
    view.right = {std::cos(azimuth), -std::sin(azimuth)};
    view.exaggeration = random.between(0.5, 3);
    const SurfaceCutter cutter(surface, view, level, {});
    for (int k = 0; k < 5; ++k) {
      const double depth_m = random.between(cutter.nearest_m(), cutter.farthest_m());
      const PlacesAlong at{random.between(-900, 0), random.between(0.1, 20), 120};
      HeightsAlong direct, of_cut;
      cutter.heights(depth_m, at, direct);
      Profile profile;
      cutter.cut(depth_m, profile);
      heights_along(profile, at, of_cut);
      INFO("seed " << seed);
      for (std::size_t i = 0; i < at.count; ++i) {
        if (std::isnan(direct.z_m[i]) != std::isnan(of_cut.z_m[i])) {
          ++at_edges; // of the grid or of a gap, by rounding
          continue;
        }
        if (std::isnan(direct.z_m[i])) {
          ++without_ground;
          continue;
        }
        ++compared;
        CHECK(std::abs(direct.z_m[i] - of_cut.z_m[i]) < 1e-6); // heights up to 150
        at_edges += direct.is_level[i] != of_cut.is_level[i];
        level_count += direct.is_level[i];
      }
    }
  }
  CHECK(compared > 10 * last_seed(2000));
  CHECK(without_ground > compared / 10);
  CHECK(level_count > compared / 10);
  CHECK(at_edges <= compared / 1000);
}

TEST_CASE("in degrees heights along a profile are those of its cut a metre aside") {
  std::size_t compared = 0, at_edges = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    Random random(seed);
    const double step_deg = random.between(3e-4, 9e-4);
    const DegreeLattice degrees{random.between(-180, 180),
                                step_deg * random.between(1, 2),
                                160,
                                random.between(-70, 70),
                                -step_deg,
                                160};
    // The frame's origin lies up to 1.5 degrees away, so that uprights lean.
    const LocalFrame frame(degrees.middle_lon_deg() + random.between(-1.5, 1.5),
                           degrees.lat_deg(80) + random.between(-1.5, 1.5));
    std::vector<float> heights(160U * 160U);
    for (std::size_t i = 0; i < heights.size(); ++i)
      heights[i] = static_cast<float>(2000 + 100 * std::sin(0.002 * static_cast<double>(i % 160) *
                                                            static_cast<double>(i / 160)));
    const double exaggeration = random.between(0.5, 2);
    const Surface surface =
        Grid{160, 160, EarthLattice(degrees, frame, exaggeration), Heights<float>(heights)};
    const Grid& grid = std::get<Grid>(surface);
    REQUIRE(has_heights_along(grid));
    View view;
    view.projection = Projection::orthographic;
    const double azimuth = random.between(0, 6.28);
    view.forward = {std::sin(azimuth), std::cos(azimuth)};
    view.right = {std::cos(azimuth), -std::sin(azimuth)};
    const TriangleSet level;
    const auto border =
        std::make_shared<const BorderPlaces>(border_places(grid, border_edges(grid, true)));
    const SurfaceCutter cutter(surface, view, level, {border, nullptr, nullptr});
    for (int k = 0; k < 5; ++k) {
      const double depth_m = random.between(cutter.nearest_m(), cutter.farthest_m());
      Profile profile;
      cutter.cut(depth_m, profile);
      if (profile.size() < 2) continue;
      const double width_m = profile.u_m.back() - profile.u_m.front();
      const PlacesAlong at{profile.u_m.front() - 0.1 * width_m, 1.2 * width_m / 400, 400};
      HeightsAlong direct, of_cut;
      cutter.heights(depth_m, at, direct);
      INFO("seed " << seed);
      // The cut's range of heights within 3 m of each place, and 3 m up and down for slopes of 45
      // degrees across the profile.
      constexpr double kAside_m = 3;
      heights_along(profile, at, of_cut);
      HeightsAlong left, right;
      heights_along(profile, {at.begin_m - kAside_m, at.step_m, at.count}, left);
      heights_along(profile, {at.begin_m + kAside_m, at.step_m, at.count}, right);
      for (std::size_t i = 0; i < at.count; ++i) {
        if (std::isnan(direct.z_m[i]) != std::isnan(of_cut.z_m[i])) {
          ++at_edges;
          continue;
        }
        if (std::isnan(left.z_m[i]) || std::isnan(right.z_m[i])) continue;
        ++compared;
        const auto [low, high] = std::minmax({left.z_m[i], of_cut.z_m[i], right.z_m[i]});
        CHECK(direct.z_m[i] > low - 2 * kAside_m);
        CHECK(direct.z_m[i] < high + 2 * kAside_m);
      }
    }
    // Asked together, profiles of different lengths are what each is alone.
    std::vector<HeightsAlong> together(6);
    std::vector<AskedProfile> asked;
    const double size_m = cutter.farthest_m() - cutter.nearest_m();
    for (HeightsAlong& heights_m : together)
      asked.push_back({random.between(cutter.nearest_m(), cutter.farthest_m()),
                       {-size_m, random.between(0.002, 0.02) * size_m,
                        static_cast<std::size_t>(random.whole(1, 500))},
                       &heights_m});
    cutter.heights(asked);
    for (const auto& [depth_m, at, of_all] : asked) {
      HeightsAlong alone;
      cutter.heights(depth_m, at, alone);
      CHECK(std::ranges::equal(alone.z_m, of_all->z_m, [](double a, double b) {
        return a == b || (std::isnan(a) && std::isnan(b));
      }));
    }
  }
  CHECK(compared > 500 * last_seed(60));
  CHECK(at_edges < compared / 50);
}

} // namespace orograph::heights_along_test
