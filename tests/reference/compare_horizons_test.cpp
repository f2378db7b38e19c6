// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of a horizon's size: what it counts, and that it sees what is wrong. The true horizon
// itself, by brute force.
#include "horizon/clip.hpp"
#include "reference/compare_horizons.hpp"
#include "reference/exact_clip.hpp"
#include "tests/catch.hpp"
#include "tests/horizon/flat_scenes.hpp"
#include "tests/reference/hard_scenes.hpp"
#include "tests/support/envelope_size.hpp"

#include <cmath>

namespace orograph::compare_horizons_test {
namespace {

Segment level(double x0, double x1, double y, std::uint64_t id) {
  return {x0, y, x1, y, id};
}

// A horizon of these sources, up to these ends; the sky where there is none.
struct End {
  double x;
  const Segment* source;
  bool inked = false;
};
Horizon horizon_of(const std::vector<End>& ends) {
  Horizon horizon;
  double begin = -kInfinity;
  for (const End& end : ends) {
    const Segment sky = initial_horizon().front().source;
    horizon.push_back({begin, end.x, end.source ? *end.source : sky, end.inked});
    begin = end.x;
  }
  return horizon;
}

TieTolerance tolerance_of(double mm) {
  return {mm, Homography{}, mm}; // a page of 1 mm to each unit
}

void check_adds_up(const Horizon& kept, const Horizon& least, const HorizonDifferences& found) {
  CHECK(kept.size() + found.ties_fewer ==
        least.size() + found.ties_more + found.marks + found.fragments);
}

// All parts of all lists as pieces.
std::vector<HorizonPiece> pieces_of(const FlatScene& scene) {
  std::vector<HorizonPiece> pieces;
  for (const auto& segments : scene)
    for (const Segment& s : segments) pieces.push_back({s.x0, s.x1, s, false});
  return pieces;
}

} // namespace

TEST_CASE("a horizon that is the true one has no differences") {
  const Segment a = level(0, 4, 1, 1), b = level(4, 6, 2, 2);
  const Horizon horizon = horizon_of({{0, nullptr}, {4, &a}, {6, &b}, {kInfinity, nullptr}});
  const auto found = compare_horizons(horizon, horizon, {});
  CHECK(found.has_least_size());
  CHECK(found.stretches + found.ties_more + found.ties_fewer + found.marks == 0);
}

TEST_CASE("what isn't joined is a fragment; what ink tells apart is a mark") {
  const Segment a = level(0, 4, 1, 1);
  const Horizon least = horizon_of({{0, nullptr}, {4, &a}, {kInfinity, nullptr}});
  const Horizon parted =
      horizon_of({{0, nullptr}, {1, &a}, {2, &a}, {4, &a}, {kInfinity, nullptr}});
  auto found = compare_horizons(parted, least, {});
  CHECK(found.fragments == 2);
  CHECK_FALSE(found.has_least_size());
  check_adds_up(parted, least, found);

  const Horizon marked =
      horizon_of({{0, nullptr}, {1, &a}, {2, &a, true}, {4, &a}, {kInfinity, nullptr}});
  found = compare_horizons(marked, least, {});
  CHECK(found.fragments == 0);
  CHECK(found.marks == 2);
  CHECK(found.has_least_size());
  check_adds_up(marked, least, found);
}

TEST_CASE("a stretch within the tolerance is a tie, and one beyond it is wrong") {
  const Segment a = level(0, 4, 1, 1), b = level(1, 3, 1 + 1e-5, 2);
  const Horizon least = horizon_of({{0, nullptr}, {1, &a}, {3, &b}, {4, &a}, {kInfinity, nullptr}});
  const Horizon kept = horizon_of({{0, nullptr}, {4, &a}, {kInfinity, nullptr}});
  auto found = compare_horizons(kept, least, tolerance_of(1e-4));
  CHECK(found.has_least_size());
  CHECK(found.stretches == 1);
  CHECK(found.ties_fewer == 2);
  CHECK(std::abs(found.farthest_mm - 1e-5) < 1e-12);
  check_adds_up(kept, least, found);

  found = compare_horizons(kept, least, tolerance_of(1e-6));
  CHECK(found.wrong == 1);
  CHECK_FALSE(found.has_least_size());
  check_adds_up(kept, least, found);

  // The other way round the tie adds two ends.
  found = compare_horizons(least, kept, tolerance_of(1e-4));
  CHECK(found.ties_more == 2);
  check_adds_up(least, kept, found);
}

TEST_CASE("sky in the place of a source is wrong, unless it is no wider than rounding") {
  const Segment a = level(0, 4, 1, 1);
  const Horizon least = horizon_of({{0, nullptr}, {4, &a}, {kInfinity, nullptr}});
  const auto ends_at = [&](double x) {
    return horizon_of({{0, nullptr}, {x, &a}, {kInfinity, nullptr}});
  };
  CHECK(compare_horizons(ends_at(3.999), least, tolerance_of(1)).wrong == 1);
  const auto found = compare_horizons(ends_at(std::nextafter(4.0, 0.0)), least, {});
  CHECK(found.has_least_size());
  CHECK(found.ties_more + found.ties_fewer == 0);
}

TEST_CASE("pieces of the true horizon that rounding leaves no width are ties") {
  const Segment a = level(0, 4, 1, 1), b = level(4, 6, 1, 2), c = level(3, 5, 0, 3);
  const Horizon kept = horizon_of({{0, nullptr}, {4, &a}, {6, &b}, {kInfinity, nullptr}});
  Horizon least = horizon_of({{0, nullptr}, {4, &a}, {4, &c}, {6, &b}, {kInfinity, nullptr}});
  const auto found = compare_horizons(kept, least, {});
  CHECK(found.has_least_size());
  CHECK(found.ties_fewer == 1);
  check_adds_up(kept, least, found);
}

TEST_CASE("the true horizon's size, by brute force") {
  for (const SceneKind& kind : scene_kinds()) {
    if (kind.y_scale > 10 || kind.y_scale < 0.1 || kind.offset != 0) continue;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      CAPTURE(kind.name, seed);
      FlatScene scene = flat_scene(kind, seed);
      scene.resize(std::min<std::size_t>(scene.size(), 8));
      ExactHorizon by_lists, by_pieces;
      std::vector<Segment> in_front;
      for (const auto& segments : scene) {
        by_lists.clip({segments, Role::drawn_occluder});
        in_front.insert(in_front.end(), segments.begin(), segments.end());
        REQUIRE(by_lists.size() == envelope_size(in_front));
      }
      by_pieces.raise(pieces_of(scene));
      CHECK(by_pieces.size() == by_lists.size());
      const Horizon pieces = by_lists.pieces();
      CHECK(pieces.size() == by_lists.size());
      CHECK(std::isinf(pieces.front().x_begin));
      CHECK(std::isinf(pieces.back().x_end));
    }
  }
}

TEST_CASE("a source that comes piece by piece is one piece") {
  const Segment a{0, 0, 4, 4, 1}, b = level(0, 4, 1, 2);
  ExactHorizon horizon;
  horizon.raise(std::vector<HorizonPiece>{{0, 1, a, false}, {3, 4, a, false}});
  CHECK(horizon.size() == 5);
  horizon.raise(std::vector<HorizonPiece>{{1, 3, a, false}});
  CHECK(horizon.size() == 3);
  horizon.raise(std::vector<HorizonPiece>{{0, 4, b, false}});
  CHECK(horizon.size() == 4);
  CHECK(horizon.pieces()[1].x_end == 1);
}

TEST_CASE("collapse keeps the least size, ties apart; without it there are fragments",
          "[unsanitized]") {
  for (const SceneKind& kind : scene_kinds())
    for (const Role role : {Role::drawn_occluder, Role::occluder})
      for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        CAPTURE(kind.name, seed);
        const FlatScene scene = flat_scene(kind, seed);
        ExactHorizon exact;
        Horizon collapsed = initial_horizon(), fragmented = initial_horizon();
        ClipWorkspace workspace;
        for (const auto& segments : scene) {
          clip(segments, collapsed, {role, {}, true}, workspace);
          clip(segments, fragmented, {role, {}, false}, workspace);
          exact.clip({segments, role});
          const Horizon least = exact.pieces();
          const auto found = compare_horizons(collapsed, least, {});
          CAPTURE(found.fragments, found.wrong, found.stretches);
          REQUIRE(found.has_least_size());
          check_adds_up(collapsed, least, found);
          const auto without = compare_horizons(fragmented, least, {});
          check_adds_up(fragmented, least, without);
        }
        CHECK(compare_horizons(fragmented, exact.pieces(), {}).fragments > 0);
      }
}

TEST_CASE("collapse keeps the least size on hard scenes, ties apart", "[unsanitized]") {
  std::size_t ties = 0;
  for (const HardKind& kind : hard_kinds())
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
      CAPTURE(kind.name, seed);
      ExactHorizon exact;
      Horizon collapsed = initial_horizon();
      ClipWorkspace workspace;
      for (const auto& segments : hard_scene(kind, seed)) {
        clip(segments, collapsed, {Role::drawn_occluder, {}, true}, workspace);
        exact.clip({segments, Role::drawn_occluder});
        const Horizon least = exact.pieces();
        const auto found = compare_horizons(collapsed, least, {});
        CAPTURE(found.fragments, found.wrong, found.stretches);
        REQUIRE(found.has_least_size());
        check_adds_up(collapsed, least, found);
        ties += found.ties_more + found.ties_fewer;
      }
    }
  CHECK(ties > 100);
}

} // namespace orograph::compare_horizons_test
