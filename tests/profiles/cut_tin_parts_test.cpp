// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/tin_index.hpp"
#include "profiles/cut_mesh.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/compare_parts.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/random.hpp"

#include <cstdint>
#include <memory>

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
  CHECK(sum.vertices > enough<50000>);
  CHECK(sum.gaps > enough<1000>);
  CHECK(sum.shorter > enough<10000>);
}

} // namespace orograph::cut_tin_parts_test
