// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/tin_index.hpp"
#include "profiles/cut_mesh.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/compare_parts.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace orograph::cut_tin_parts_test {

TEST_CASE("parts of a TIN's profiles are those of whole ones, bit for bit") {
  const TriangleSet no_level;
  Parts sum;
  for (std::uint64_t seed = 1; seed <= last_seed(1500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    MadeTin wanted;
    wanted.columns = random.whole(2, 12);
    wanted.rows = random.whole(2, 12);
    wanted.missing = random.pick({0.0, 0.05, 0.3, 0.7});
    wanted.walls = random.pick({0.0, 0.0, 0.0, 0.5}); // with walls parts are whole profiles
    wanted.whole = random.chance(0.5);
    wanted.step_m = 8;
    wanted.moved = random.pick({0.0, 0.2});
    wanted.shuffled = random.chance(0.5);
    const double offset = random.pick({0.0, 100.0, 1e6});
    wanted.first_vertex_m = {8.0 * random.whole(-9, 9) + offset, 8.0 * random.whole(-9, 9)};
    const Tin tin = made_tin(random, wanted);
    if (tin.triangles.empty()) continue;
    View view = looking(direction_of_azimuth(
        Angle::degrees(random.chance(0.5) ? 45.0 * random.whole(0, 7) : random.between(0, 360))));
    view.depth_origin_m = wanted.first_vertex_m + Vec2{random.between(-9, 90), 20};
    const auto places = std::make_shared<const TinPlaces>(tin_places(tin));
    const TinCutter whole(tin, view, no_level, places),
        cutter(tin, view, no_level, places, std::make_shared<const TinIndex>(tin));
    for (int i = 0; i < 8; ++i) {
      const ProfilePoint vertex =
          to_profile_frame(view, tin.vertices_m[static_cast<std::size_t>(random.whole(
                                     0, static_cast<int>(tin.vertices_m.size()) - 1))]);
      compare_parts(random, whole, cutter,
                    random.chance(0.5) ? vertex.v
                                       : random.between(whole.nearest_m(), whole.farthest_m()),
                    sum);
    }
  }
  CHECK(sum.vertices > enough(50000));
  CHECK(sum.gaps > enough(1000));
  CHECK(sum.shorter > enough(10000));
}

// A place there is a sum that cancels, and is off by what its parts round to.
TEST_CASE("a part that begins at the frame's own origin has what begins there, or ends") {
  const TriangleSet no_level;
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    View view = looking(direction_of_azimuth(Angle::degrees(random.between(0, 360))));
    view.depth_origin_m = {random.between(-100, 100), random.between(-100, 100)};
    // To the left of the origin or to the right.
    const double side = random.pick({-1.0, 1.0});
    const Vec2 near = 5.0 * (side * view.right) - 4.0 * view.forward,
               far = 6.0 * (side * view.right) + 3.0 * view.forward;
    Tin tin;
    tin.vertices_m = {{0, 0, 16}, {near.x, near.y, 40}, {far.x, far.y, 11}};
    tin.triangles = {{0, 1, 2}};
    if (side < 0) std::swap(tin.triangles[0][1], tin.triangles[0][2]);
    tin.neighbours = {{kNoTriangle, kNoTriangle, kNoTriangle}};
    const auto places = std::make_shared<const TinPlaces>(tin_places(tin));
    const TinCutter cutter(tin, view, no_level, places, std::make_shared<const TinIndex>(tin));
    const ProfilePoint origin = to_profile_frame(view, tin.vertices_m[0]);
    const URange part{origin.u, origin.u + 1};
    Profile some;
    cutter.cut(origin.v, std::span(&part, 1), some);
    REQUIRE(std::ranges::find(some.u_m, origin.u) != some.u_m.end());
  }
}

} // namespace orograph::cut_tin_parts_test
