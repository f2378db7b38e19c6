// SPDX-License-Identifier: GPL-3.0-or-later
// The view that shows most ground with most relief: its score against the ray walk, and what it
// takes of terrains of which one knows it.
#include "geometry/on_all_cores.hpp"
#include "placing/choose_view.hpp"
#include "placing/placed_view.hpp"
#include "placing/terrain_of_view.hpp"
#include "reference/ray_walk.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_earth_scene.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/random_tin_scene.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stop_token>
#include <vector>

using namespace orograph;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

template <class Height>
CoarseGround ground_of(int columns, int rows, double step_m, const Height& height) {
  CoarseGround out{columns, rows, step_m, {}};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) out.z_m.push_back(height(column, row));
  return out;
}

// Its rows from the north, as grids have them.
Grid grid_of(const CoarseGround& ground) {
  std::vector<double> heights;
  for (int row = ground.rows - 1; row >= 0; --row)
    for (int column = 0; column < ground.columns; ++column)
      heights.push_back(ground.at(column, row));
  return Grid{
      ground.columns, ground.rows,
      PlaneLattice{{0, (ground.rows - 1) * ground.step_m}, {ground.step_m, 0}, {0, -ground.step_m}},
      std::move(heights)};
}

View parallel_view(Angle azimuth, Angle elevation) {
  View view;
  view.projection = Projection::orthographic;
  view.forward = Vec2{} - direction_of_azimuth(azimuth);
  view.right = {view.forward.y, 0 - view.forward.x};
  view.elevation = elevation;
  view.y_per_z = cos(elevation);
  view.y_per_v = sin(elevation);
  return view;
}

CoarseGround random_ground(Random& random) {
  const double most_m = random.pick({5.0, 40.0, 200.0});
  return ground_of(random.whole(2, 18), random.whole(2, 18), 10,
                   [&](int, int) { return random.between(0, most_m); });
}

TerrainData terrain_of(const CoarseGround& ground) {
  TerrainData terrain;
  terrain.surface = grid_of(ground);
  return terrain;
}

ChosenView chosen(const TerrainData& terrain, MapSpec spec = {}) {
  spec.view.from_auto = true;
  const TerrainOfView of_view(terrain, spec.view);
  return placed_view(of_view, spec).chosen_view.value();
}

} // namespace

TEST_CASE("what a viewer sees of coarse ground is what the ray walk sees") {
  std::size_t seen = 0, hidden = 0, ties = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(150); ++seed) {
    Random random(seed);
    const CoarseGround ground = random_ground(random);
    const Grid grid = grid_of(ground);
    const Angle azimuth = Angle::degrees(random.pick(
        {0.0, 90.0, 135.0, 225.0, 315.0, 22.5 * random.whole(0, 15), random.between(0, 360)}));
    const std::vector<double> slopes = slopes_to_see(ground, azimuth);
    for (const double elevation_deg : kTriedElevations_deg) {
      const Angle elevation = Angle::degrees(elevation_deg);
      const View view = parallel_view(azimuth, elevation);
      const RayWalk walk(grid, view);
      for (int row = 0; row < ground.rows; ++row)
        for (int column = 0; column < ground.columns; ++column) {
          const std::size_t i = static_cast<std::size_t>(row * ground.columns + column);
          const ProfilePoint p = to_profile_frame(
              view, {column * ground.step_m, row * ground.step_m, ground.at(column, row)});
          const InFront before = walk.in_front(p);
          const double over = before.greatest_y_apart - project(view, p).y; // it is a vertex
          if (std::abs(over) <= 1e-9 || std::abs(slopes[i] - tan(elevation)) <= 1e-9) {
            ++ties;
            continue;
          }
          CAPTURE(seed, column, row, elevation_deg, slopes[i], over);
          CHECK((slopes[i] > tan(elevation)) == (over > 0));
          ++(over > 0 ? hidden : seen);
        }
    }
  }
  CHECK(seen > enough(20000));
  CHECK(hidden > enough(20000));
  CHECK(ties < seen / 100);
}

TEST_CASE("no tried view scores more than the chosen one") {
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    Random random(seed);
    const CoarseGround ground = random_ground(random);
    const ChosenView best = choose_view(ground);
    // Each place's worth, by its own words.
    const auto at = [&](int column, int row) { return ground.at(column, row); };
    std::vector<double> steep, uphill_rad;
    double mean = 0;
    for (int r = 0; r < ground.rows; ++r)
      for (int c = 0; c < ground.columns; ++c) {
        const int w = c > 0 ? c - 1 : c, e = c + 1 < ground.columns ? c + 1 : c;
        const int s = r > 0 ? r - 1 : r, n = r + 1 < ground.rows ? r + 1 : r;
        const double east = (at(e, r) - at(w, r)) / ((e - w) * ground.step_m);
        const double north = (at(c, n) - at(c, s)) / ((n - s) * ground.step_m);
        const double angle = std::atan(std::sqrt(east * east + north * north));
        steep.push_back(std::sin(angle));
        uphill_rad.push_back(std::atan2(east, north));
        mean += steep.back() / static_cast<double>(ground.z_m.size());
      }
    double greatest = 0;
    const Grid grid = grid_of(ground);
    for (int azimuth = 0; azimuth < 16; ++azimuth)
      for (const double elevation_deg : kTriedElevations_deg) {
        const View view =
            parallel_view(Angle::degrees(22.5 * azimuth), Angle::degrees(elevation_deg));
        const RayWalk walk(grid, view);
        double score = 0;
        for (std::size_t i = 0; i < steep.size(); ++i) {
          const int column = static_cast<int>(i) % ground.columns;
          const int row = static_cast<int>(i) / ground.columns;
          const ProfilePoint p = to_profile_frame(
              view, {column * ground.step_m, row * ground.step_m, ground.at(column, row)});
          const bool is_seen = walk.in_front(p).greatest_y_apart <= project(view, p).y + 1e-9;
          // 1 where it faces the viewer, who is down the slope.
          const double faces = 0.5 - 0.5 * std::cos(uphill_rad[i] - azimuth * std::numbers::pi / 8);
          if (is_seen) score += (1 + faces * steep[i] / mean) / 2;
        }
        score /= static_cast<double>(steep.size());
        greatest = std::max(greatest, score * std::cos(elevation_deg * std::numbers::pi / 180));
      }
    CAPTURE(seed, best.azimuth.in_degrees(), best.elevation.in_degrees());
    CHECK(std::abs(best.score - greatest) <= 1e-9);
  }
}

TEST_CASE("a wall in the north and a slope towards the south are seen from the south") {
  // By 45 degrees down to the south, behind it a wall's steep back, turned to each side.
  const auto slope = [](int away) { return away < 36 ? 10.0 * away : 0.0; };
  const auto side = [&](const auto& height) {
    return choose_view(ground_of(40, 40, 10, height)).azimuth;
  };
  CHECK(side([&](int, int r) { return slope(r); }) == Angle::degrees(180));
  CHECK(side([&](int c, int) { return slope(c); }) == Angle::degrees(270));
  CHECK(side([&](int, int r) { return slope(39 - r); }) == Angle::degrees(0));
  CHECK(side([&](int c, int) { return slope(39 - c); }) == Angle::degrees(90));
}

TEST_CASE("level ground is seen from the south, and voids count for nothing") {
  const ChosenView level = choose_view(ground_of(12, 9, 5, [](int, int) { return 7.0; }));
  CHECK(level.azimuth == Angle::degrees(180));
  CHECK(level.seen_share == 1);
  CHECK(std::abs(level.score - std::cos(10 * std::numbers::pi / 180)) <= 1e-12);
  const ChosenView holes =
      choose_view(ground_of(12, 9, 5, [](int c, int r) { return (c * r) % 3 == 0 ? kNone : 7.0; }));
  CHECK(holes.seen_share == 1);
  CHECK(std::abs(holes.score - level.score) <= 1e-12);
}

TEST_CASE("coarse ground has the terrain's heights") {
  const auto plane_m = [](Vec2 at) { return 100 + 0.5 * at.x - 0.25 * at.y; };
  const CoarseGround fine = ground_of(300, 200, 3, [&](int c, int r) {
    return plane_m({3.0 * c, 3.0 * r});
  });
  const TerrainData terrain = terrain_of(fine);
  const TerrainFacts facts = facts_of(terrain);
  const CoarseGround coarse = coarse_ground(
      {terrain.surface, facts.water.triangles, facts.for_cutters}, facts.extent.box, 3, 2);
  CHECK(coarse.columns == kCoarseCells);
  CHECK(coarse.rows == 85); // 128 times 597 / 897
  const double east_m = 0.5 * (897 - (coarse.columns - 1) * coarse.step_m),
               north_m = 0.5 * (597 - (coarse.rows - 1) * coarse.step_m);
  double farthest = 0;
  for (int r = 0; r < coarse.rows; ++r)
    for (int c = 0; c < coarse.columns; ++c)
      farthest = std::max(farthest,
                          std::abs(coarse.at(c, r) - 2 * plane_m({east_m + c * coarse.step_m,
                                                                  north_m + r * coarse.step_m})));
  CHECK(farthest <= 1e-9);
}

TEST_CASE("TINs and degrees are chosen for as well, on any number of threads", "[unsanitized]") {
  for (std::uint64_t seed = 1; seed <= last_seed(10); ++seed) {
    CAPTURE(seed);
    std::vector<TerrainData> terrains{random_scene(seed).terrain, random_tin_scene(seed).terrain,
                                      random_earth_scene(seed, Stand::frames_terrain).terrain};
    for (const TerrainData& terrain : terrains) {
      std::optional<ChosenView> alone, together;
      on_cores(1, {}, [&] { alone = chosen(terrain); });
      on_cores(2, {}, [&] { together = chosen(terrain); });
      CHECK(alone->azimuth == together->azimuth);
      CHECK(alone->elevation == together->elevation);
      CHECK(alone->score == together->score);
      CHECK(alone->score > 0);
      CHECK(alone->score <= 1 + 1e-12);
    }
  }
}
