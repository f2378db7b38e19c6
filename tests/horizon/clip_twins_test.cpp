// SPDX-License-Identifier: GPL-3.0-or-later
// `clip` against the seed's recursion, with and without collapse, in its three roles.
#include "horizon/clip.hpp"
#include "tests/catch.hpp"
#include "tests/horizon/flat_scenes.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>

namespace orograph::clip_twins_test {
namespace {

bool same_horizon(const Horizon& a, const Horizon& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const HorizonPiece& p, const HorizonPiece& q) {
                      return p.x_begin == q.x_begin && p.x_end == q.x_end &&
                             p.source.id == q.source.id && p.inked == q.inked;
                    });
}

ClipOptions options_of(Role role, double tolerance, bool collapse = true) {
  return {role, {tolerance, Homography{}, tolerance}, collapse};
}

double height_on(const Horizon& horizon, double x) {
  for (const HorizonPiece& piece : horizon)
    if (piece.x_begin <= x && x <= piece.x_end)
      return is_sky(piece) ? piece.source.y0 : height_at(piece.source, x);
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace

TEST_CASE("clip and the seed's recursion give the same pieces and horizons") {
  for (const SceneKind& kind : scene_kinds())
    for (const Role role : {Role::drawn_occluder, Role::occluder, Role::compared})
      for (std::uint64_t seed = 1; seed <= last_seed(30); ++seed)
        for (const bool collapse : {true, false}) {
          CAPTURE(kind.name, seed, collapse, static_cast<int>(role));
          const ClipOptions options = options_of(role, seed % 2 ? 0.05 : 0, collapse);
          // Lists of both kinds, so that each role meets a horizon that isn't only sky.
          const ClipOptions raising = options_of(Role::drawn_occluder, 0, collapse);
          const FlatScene scene = flat_scene(kind, seed);
          Horizon looped = initial_horizon();
          ClipWorkspace workspace;
          for (std::size_t i = 0; i < scene.size(); ++i) {
            const ClipOptions& now = i % 2 ? options : raising;
            const ClipResult recursive = clip_recursive(scene[i], looped, now);
            clip(scene[i], looped, now, workspace);
            REQUIRE(recursive.visible == workspace.visible);
            // What is compared doesn't fragment the loop's horizon, as it does the recursion's.
            if (now.role != Role::compared || collapse)
              REQUIRE(same_horizon(recursive.horizon, looped));
          }
        }
}

TEST_CASE("collapse changes no visible piece and removes fragments") {
  std::size_t without = 0, with = 0;
  for (const SceneKind& kind : scene_kinds())
    for (std::uint64_t seed = 1; seed <= last_seed(40); ++seed) {
      CAPTURE(kind.name, seed);
      const FlatScene scene = flat_scene(kind, seed);
      Horizon collapsed = initial_horizon(), fragmented = initial_horizon();
      ClipWorkspace a, b;
      for (const auto& list : scene) {
        clip(list, collapsed, options_of(Role::drawn_occluder, 0, true), a);
        clip(list, fragmented, options_of(Role::drawn_occluder, 0, false), b);
        REQUIRE(a.visible == b.visible);
      }
      with += collapsed.size();
      without += fragmented.size();
    }
  WARN("horizon pieces without collapse " << without << ", with " << with);
  REQUIRE(with < without);
}

TEST_CASE("the horizon never sinks, tiles X, and keeps no neighbouring pieces of one source") {
  for (const SceneKind& kind : scene_kinds())
    for (std::uint64_t seed = 1; seed <= last_seed(20); ++seed) {
      CAPTURE(kind.name, seed);
      Random random(seed);
      Horizon horizon = initial_horizon();
      ClipWorkspace workspace;
      const FlatScene scene = flat_scene(kind, seed);
      for (const auto& list : scene) {
        const Horizon before = horizon;
        clip(list, horizon, options_of(Role::occluder, 0), workspace);
        REQUIRE(workspace.visible.empty());
        REQUIRE(std::isinf(horizon.front().x_begin));
        REQUIRE(std::isinf(horizon.back().x_end));
        for (std::size_t i = 0; i + 1 < horizon.size(); ++i) {
          REQUIRE(horizon[i].x_end == horizon[i + 1].x_begin);
          REQUIRE(horizon[i].x_begin < horizon[i].x_end);
          REQUIRE(horizon[i].source.id != horizon[i + 1].source.id);
        }
        for (int i = 0; i < 50; ++i) {
          const double x = kind.offset + random.between(-1, 40);
          const double was = height_on(before, x), is = height_on(horizon, x);
          const double rounding = 1e-12 * (std::abs(is) + kind.y_scale);
          REQUIRE((is >= was || was - is <= rounding));
        }
      }
    }
}

TEST_CASE("a compared list leaves the horizon as it was and shows what a drawn one would") {
  for (const SceneKind& kind : scene_kinds())
    for (std::uint64_t seed = 1; seed <= last_seed(20); ++seed) {
      CAPTURE(kind.name, seed);
      const FlatScene scene = flat_scene(kind, seed);
      Horizon horizon = initial_horizon();
      ClipWorkspace drawn, compared;
      for (const auto& list : scene) {
        Horizon copy = horizon;
        clip(list, copy, options_of(Role::compared, 0), compared);
        REQUIRE(same_horizon(copy, horizon));
        clip(list, horizon, options_of(Role::drawn_occluder, 0), drawn);
        REQUIRE(compared.visible == drawn.visible);
      }
    }
}

} // namespace orograph::clip_twins_test
