// SPDX-License-Identifier: GPL-3.0-or-later
// Upright lines of a block's walls: none at each step of a border that is seen nearly edge-on.
#include "hidden_lines/close_uprights.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/support/grid_of.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace orograph::block_uprights_test {

TEST_CASE("of uprights that are close to each other along a border the outermost stays") {
  const std::vector<TurnedAway> along{{1, 0}, {2, 0.5}, {3, 1.2}, {4, 0.9}, {5, 3}, {6, 3.5}};
  CHECK(too_close(along, 1, true) == std::vector<std::uint32_t>{1, 2, 4, 5});
  CHECK(too_close(along, 1, false) == std::vector<std::uint32_t>{2, 3, 4, 6});
  CHECK(too_close(along, 0.1, true).empty());
}

TEST_CASE("a border in steps has no upright line at each of them where it is seen nearly edge-on") {
  RandomScene scene = random_scene(3);
  Grid& grid = grid_of(scene.terrain);
  grid.columns = grid.rows = 120;
  std::vector<float> heights(120UL * 120, 10);
  for (std::size_t row = 0; row < 120; ++row) // a step every five rows
    for (std::size_t column = 60 + row / 5; column < 120; ++column)
      heights[row * 120 + column] = std::numeric_limits<float>::quiet_NaN();
  heights.front() = 30;
  grid.heights_m = std::move(heights);
  scene.spec.view = {};
  scene.spec.view.projection = Projection::orthographic;
  scene.spec.view.from_elevation = Angle::degrees(25);
  scene.spec.style = {};
  scene.spec.style.layers.emplace_back("block");
  scene.spec.style.block.sides = BlockSides::outline;
  const auto uprights = [&](double from_deg) {
    scene.spec.view.from_azimuth = Angle::degrees(from_deg);
    const PlacedView placed = placed_view(scene.terrain, scene.spec);
    const GroundLines lines = ground_lines_of(scene.terrain, placed, scene.spec.style);
    const auto first = static_cast<std::uint32_t>(vertex_count(scene.terrain.surface));
    return std::ranges::count_if(lines.lines, [&](const GroundLine& line) {
      const ProfilePoint &a = lines.points[line.ends.from - first],
                         &b = lines.points[line.ends.to - first];
      return a.u == b.u && a.v == b.v;
    });
  };
  for (const double from_deg : {165.0, 169.0, 171.0, 180.0, 190.0, 350.0, 10.0})
    CHECK(uprights(from_deg) <= 8);
}

} // namespace orograph::block_uprights_test
