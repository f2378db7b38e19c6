// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/catch.hpp"
#include "tests/horizon/check_clip.hpp"
#include "tests/support/random.hpp"

namespace orograph::clip_definition_test {
namespace {

Tally check_scene(const FlatScene& scene, double tolerance, std::uint64_t seed) {
  return check_clip(scene, tolerance, Homography{}, tolerance, seed);
}

} // namespace

TEST_CASE("a piece is above all nearer lists, or is not, as it claims") {
  for (const SceneKind& kind : scene_kinds()) {
    Tally sum;
    for (std::uint64_t seed = 1; seed <= last_seed(80); ++seed) {
      CAPTURE(kind.name, seed);
      const Tally tally = check_scene(flat_scene(kind, seed), 0, seed);
      REQUIRE(tally.wrong == 0);
      sum.asked += tally.asked;
      sum.ties += tally.ties;
    }
    WARN(kind.name << ": " << sum.asked << " asked, " << sum.ties << " ties");
    REQUIRE(sum.asked > enough(10000));
    // A lattice is made of ties; elsewhere a check that skips much checks little.
    if (!kind.lattice) REQUIRE(sum.ties < sum.asked / 50);
  }
}

TEST_CASE("with a tolerance, only what is within it of the horizon is tied") {
  for (const SceneKind& kind : scene_kinds()) {
    if (kind.y_scale > 10 || kind.y_scale < 0.1) continue;
    for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
      CAPTURE(kind.name, seed);
      REQUIRE(check_scene(flat_scene(kind, seed), 0.05, seed).wrong == 0);
    }
  }
}

} // namespace orograph::clip_definition_test
