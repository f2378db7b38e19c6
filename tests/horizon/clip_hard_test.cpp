// SPDX-License-Identifier: GPL-3.0-or-later
// Cases in which a clip is tempted to draw nothing, dashes, or everything.
#include "horizon/clip.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <cmath>

namespace orograph::clip_hard_test {
namespace {

ClipOptions options_of(Role role, double tolerance) {
  return {role, {tolerance, Homography{}, tolerance}, true};
}

// A list of one level segment.
std::vector<Segment> level(double y, std::uint64_t list) {
  return {{0, y, 10, y, list << 32U}};
}

} // namespace

TEST_CASE("the seed's figure 4a: a profile crosses upwards where the edges are aligned") {
  const HorizonPiece horizon{0, 10, {0, 5, 10, 5, 1}, true};
  const ClipStep step =
      clip_segments({0, 0, 20, 20, 2}, 7, 0, horizon, options_of(Role::drawn_occluder, 0));
  REQUIRE(step.draw);
  CHECK(*step.draw == Piece{7, 5, 10, 0.25, 0.5});
  REQUIRE(step.new_horizon.size() == 2);
  CHECK(step.new_horizon[0].source.id == 1);
  CHECK(step.new_horizon[1].source.id == 2);
  CHECK(step.rest_of_profile);
  CHECK(step.rest_begin == 10);
  CHECK_FALSE(step.rest_of_horizon);
}

TEST_CASE("the seed's figure 4b: three new pieces of horizon, and a rest of it") {
  const HorizonPiece horizon{0, 10, {0, 5, 10, 5, 1}, true};
  const ClipStep step =
      clip_segments({2, 8, 6, 4, 2}, 0, 2, horizon, options_of(Role::drawn_occluder, 0));
  REQUIRE(step.draw);
  CHECK(*step.draw == Piece{0, 2, 5, 0, 0.75});
  REQUIRE(step.new_horizon.size() == 3);
  CHECK(step.new_horizon[0].x_end == 2);
  CHECK(step.new_horizon[1].source.id == 2);
  CHECK(step.new_horizon[2].source.id == 1);
  CHECK_FALSE(step.rest_of_profile);
  REQUIRE(step.rest_of_horizon);
  CHECK(step.rest_of_horizon->x_begin == 6);
}

TEST_CASE("a plane seen edge-on is one line, not none and not dashes") {
  // Heights that differ by rounding, as they do where a level plane is projected.
  for (const Role role : {Role::drawn_occluder, Role::compared}) {
    Horizon horizon = initial_horizon();
    ClipWorkspace workspace;
    if (role == Role::compared)
      clip(level(0, 99), horizon, options_of(Role::occluder, 0), workspace);
    std::size_t drawn = 0;
    double length = 0;
    for (std::uint64_t list = 0; list < last_seed(50); ++list) {
      std::vector<Segment> segments;
      for (int i = 0; i < 10; ++i)
        segments.push_back({static_cast<double>(i), 1e-16 * ((i * 7 + static_cast<int>(list)) % 5),
                            i + 1.0, 1e-16 * ((i * 7 + 7 + static_cast<int>(list)) % 5),
                            (list << 32U) | static_cast<unsigned>(i)});
      clip(segments, horizon, options_of(role, 1e-6), workspace);
      drawn += workspace.visible.size();
      for (const Piece& piece : workspace.visible) length += piece.x_end - piece.x_begin;
    }
    CHECK(drawn == 10);
    CHECK(length == 10);
  }
}

TEST_CASE("ten thousand profiles that each rise by less than the tolerance are not lost") {
  const double step = 3e-5, tolerance = 1e-4;
  Horizon horizon = initial_horizon();
  ClipWorkspace workspace;
  std::uint64_t drawn = 0;
  double last = -1;
  for (std::uint64_t list = 0; list < last_seed(10000); ++list) {
    const double y = static_cast<double>(list) * step;
    clip(level(y, list), horizon, options_of(Role::drawn_occluder, tolerance), workspace);
    if (workspace.visible.empty()) continue;
    REQUIRE(workspace.visible.size() == 1);
    REQUIRE(y - last > tolerance);
    last = y;
    ++drawn;
  }
  // Every fourth is more than the tolerance above the last one drawn.
  CHECK(drawn == last_seed(10000) / 4);
}

TEST_CASE(
    "in steep perspective two lines that meet are one only where they are as close all along") {
  // The page's w falls from 1 to 0.01 on the way, and the tolerance in Y with its square.
  TieTolerance tolerance;
  tolerance.mm = 1e-4;
  tolerance.page.m = {1, 0, 0, 0, 1, 0, -0.99, 1, 1};
  tolerance.greatest_y = 1;
  const Segment nearer{0, 0, 1, 0, 1}, farther{0, 0.9e-4, 1, 0, 2},
      steeper{0, 0.9e-4, 1, 0.5e-8, 3};
  const auto apart_mm = [&](double x) {
    return length(tolerance.page({x, height_at(nearer, x)}) -
                  tolerance.page({x, height_at(farther, x)}));
  };
  REQUIRE(apart_mm(0) < tolerance.mm);
  REQUIRE(apart_mm(0.9) > 5 * tolerance.mm);
  CHECK(compare(farther, nearer, tolerance).kind == Standing::Kind::above);
  CHECK(compare(steeper, nearer, tolerance).kind == Standing::Kind::above);
  const Segment beside{0, 0.9e-8, 1, 0.5e-8, 4};
  CHECK(compare(beside, nearer, tolerance).kind == Standing::Kind::tied);
}

TEST_CASE("a profile on the horizon, a segment that shares an end, a crossing at a vertex") {
  Horizon horizon = initial_horizon();
  ClipWorkspace workspace;
  const ClipOptions options = options_of(Role::drawn_occluder, 0);
  clip(std::vector<Segment>{{0, 0, 1, 1, 1}, {1, 1, 2, 0, 2}}, horizon, options, workspace);
  clip(std::vector<Segment>{{0, 0, 1, 1, 11}, {1, 1, 2, 0, 12}}, horizon, options, workspace);
  CHECK(workspace.visible.empty());
  clip(std::vector<Segment>{{1, 1, 2, 1, 21}}, horizon, options, workspace);
  REQUIRE(workspace.visible.size() == 1);
  CHECK(workspace.visible[0] == Piece{0, 1, 2, 0, 1});
  // Through the vertex (1, 1), from above on the left to below on the right.
  clip(std::vector<Segment>{{0, 2, 2, 0, 31}}, horizon, options, workspace);
  REQUIRE(workspace.visible.size() == 1);
  CHECK(workspace.visible[0].x_begin == 0);
  CHECK(std::abs(workspace.visible[0].x_end - 1) <= 2e-16);
}

TEST_CASE("slopes of 1e12 keep the place along the segment, not only X") {
  Horizon horizon = initial_horizon();
  ClipWorkspace workspace;
  const ClipOptions options = options_of(Role::drawn_occluder, 0);
  clip(level(0.3, 1), horizon, options, workspace);
  // One unit high over 1e-12 of X, about a thousand representable abscissae at X = 5.
  const Segment needle{5, 0, 5 + 1e-12, 1, 2};
  clip(std::vector<Segment>{needle}, horizon, options, workspace);
  REQUIRE(workspace.visible.size() == 1);
  CHECK(std::abs(workspace.visible[0].t_begin - 0.3) <= 4e-16);
  CHECK(workspace.visible[0].t_end == 1);
}

TEST_CASE("zigzags make a quadratic number of visible pieces, all of them") {
  // Near: n teeth. Far: n gentle lines, each a little higher, each seen in every gap.
  const int n = 40;
  std::vector<Segment> teeth;
  for (int i = 0; i < n; ++i) {
    teeth.push_back({i + 0.0, 0, i + 0.5, 1000, static_cast<std::uint64_t>(2 * i)});
    teeth.push_back({i + 0.5, 1000, i + 1.0, 0, static_cast<std::uint64_t>(2 * i + 1)});
  }
  Horizon horizon = initial_horizon();
  ClipWorkspace workspace;
  const ClipOptions options = options_of(Role::drawn_occluder, 0);
  clip(teeth, horizon, options, workspace);
  std::size_t pieces = 0;
  for (int line = 1; line <= n; ++line) {
    clip(std::vector<Segment>{{0, line + 0.0, n + 0.0, line + 0.0,
                               static_cast<std::uint64_t>(line) << 32U}},
         horizon, options, workspace);
    pieces += workspace.visible.size();
  }
  CHECK(pieces == static_cast<std::size_t>(n) * (n + 1));
}

} // namespace orograph::clip_hard_test
