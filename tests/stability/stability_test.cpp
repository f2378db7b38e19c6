// SPDX-License-Identifier: GPL-3.0-or-later
// A slice of docs/stability.md's table, and that its judge sees what is wrong.
#include "tests/catch.hpp"
#include "tests/stability/hard_families.hpp"
#include "tests/stability/judged_view.hpp"
#include "tests/stability/sight_through_triangles.hpp"

namespace orograph::stability_test {

TEST_CASE("no point of any hard family is wrong") {
  for (const HardFamily& family : hard_families()) {
    Judged sum;
    for (std::uint64_t seed = 1; seed <= last_seed(150); ++seed) {
      Random random(seed);
      HardScene scene = family.make(random);
      const Judged one =
          judge_view(std::move(scene.terrain), scene.spec, 10, seed, random.chance(0.25));
      INFO(family.name << ", seed " << seed << ": " << one.first_wrong);
      CHECK(one.wrong == 0);
      sum.add(one);
    }
    INFO(family.name);
    CHECK(sum.points > 3 * (sum.scenes - sum.refused));
    CHECK(sum.refused < 2 + sum.scenes / 20);
    CHECK(sum.farthest_mm < 2e-3);
  }
}

TEST_CASE("sight through triangles tells what stands in front by its definition") {
  // A wall of 10 m along the second of three columns, seen from the west on the level.
  Grid grid{3, 3, PlaneLattice{{0, 0}, {10, 0}, {0, -10}},
            Heights<double>{0, 10, 0, 0, 10, 0, 0, 10, 0}};
  View view;
  view.projection = Projection::orthographic;
  view.forward = {1, 0};
  view.right = {0, -1};
  const SightThroughTriangles sight(grid, view);
  // In the profile frame u is south, v east.
  CHECK(std::abs(sight.above({5, 20, 0}) + 10) < 1e-12L); // behind the wall, 10 m below its top
  CHECK(std::abs(sight.above({5, 10, 10}) - 5) < 1e-12L); // its top, above the bend at a diagonal
  CHECK(std::isinf(sight.above({5, 0, 0})));              // that border, with nothing in front
  CHECK(std::abs(sight.above({5, 15, 5}) + 5) < 1e-12L);  // half way down its eastern side

  // In perspective from 20 m above the western border: the far foot is on the ray that leaves the
  // eye down by 1; the wall's top, 10 m away, is down by 1 as well.
  view.projection = Projection::perspective;
  view.depth_origin_m = {0, -10};
  view.eye_z_m = 20;
  view.near_m = 0.1;
  const SightThroughTriangles from_eye(grid, view);
  CHECK(std::abs(from_eye.above({0, 20, 0})) < 1e-12L);
  CHECK(from_eye.above({0, 20, -0.5}) < -0.02L);
  CHECK(from_eye.above({0, 10, 10}) > 100); // above the ground at the near plane
}

} // namespace orograph::stability_test
