// SPDX-License-Identifier: GPL-3.0-or-later
// `clip` in double draws what the exact clip draws, on random scenes and on hard ones.
#include "tests/catch.hpp"
#include "tests/reference/compare_clips.hpp"
#include "tests/reference/hard_scenes.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>

namespace orograph::clip_against_exact_test {
namespace {

const std::uint64_t kScenes = last_seed(2500);

// The seed's profiles; the surface's occluders and profiles; all three roles in turn.
std::vector<Role> roles_of(std::uint64_t seed, std::size_t lists) {
  std::vector<Role> roles(lists, Role::drawn_occluder);
  for (std::size_t i = 0; i < lists; ++i) {
    if (seed % 3 == 1) roles[i] = i % 2 ? Role::compared : Role::occluder;
    if (seed % 3 == 2) roles[i] = static_cast<Role>(i % 3);
  }
  return roles;
}

ClipDifferences compare_as(const FlatScene& scene, std::uint64_t seed) {
  ClipDifferences differences = compare_clips(scene, roles_of(seed, scene.size()));
  INFO(differences.first_wrong);
  REQUIRE(differences.wrong == 0);
  return differences;
}

} // namespace

TEST_CASE("2500 random scenes: the same pieces, ties apart, with the ends promised", "[slow]") {
  const std::vector<SceneKind> kinds = scene_kinds();
  for (const SceneKind& kind : kinds) {
    // Full size in one scene of twenty.
    ClipDifferences sum;
    for (std::uint64_t seed = 1; seed <= kScenes / kinds.size() + 1; ++seed) {
      CAPTURE(kind.name, seed);
      SceneKind sized = kind;
      if (seed % 20 != 0) {
        sized.lists = (kind.lists + 1) / 2;
        sized.segments = (kind.segments + 1) / 2;
      }
      const ClipDifferences some = compare_as(flat_scene(sized, seed), seed);
      sum.pieces += some.pieces;
      sum.exact_pieces += some.exact_pieces;
      sum.close += some.close;
      sum.farthest_end_mm = std::max(sum.farthest_end_mm, some.farthest_end_mm);
    }
    WARN(kind.name << ": " << sum.pieces << " pieces, exact " << sum.exact_pieces << ", "
                   << sum.close << " stretches of close sources; farthest end "
                   << sum.farthest_end_mm * 1e12 << "e-12 mm");
    CHECK(sum.pieces > 10 * kScenes / kinds.size());
    CHECK(sum.close <= 2 + sum.pieces / 1000);
  }
}

TEST_CASE("and hard scenes", "[slow]") {
  for (const HardKind& kind : hard_kinds()) {
    std::size_t pieces = 0, exact_pieces = 0, close = 0;
    for (std::uint64_t seed = 1; seed <= kScenes / 50; ++seed) {
      CAPTURE(kind.name, seed);
      const ClipDifferences some = compare_as(hard_scene(kind, seed), seed);
      pieces += some.pieces;
      exact_pieces += some.exact_pieces;
      close += some.close;
    }
    WARN(kind.name << ": " << pieces << " pieces, exact " << exact_pieces << ", " << close
                   << " stretches of close sources");
    CHECK(pieces > kScenes / 100);
  }
}

} // namespace orograph::clip_against_exact_test
