// SPDX-License-Identifier: GPL-3.0-or-later
// The exact clip: cases reckoned by hand, and its pieces by the definition of the horizon.
#include "reference/exact_clip.hpp"
#include "tests/catch.hpp"
#include "tests/horizon/flat_scenes.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph::exact_clip_test {
namespace {

using Segments = std::vector<Segment>;
using Pieces = std::vector<Piece>;

Segment level(double x0, double x1, double y, std::uint64_t id) {
  return {x0, y, x1, y, id};
}

double height_of(const Segment& s, double x) {
  return s.y0 + (x - s.x0) * (s.y1 - s.y0) / (s.x1 - s.x0);
}
double greatest_in_front(const FlatScene& scene, std::size_t list, double x) {
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t nearer = 0; nearer < list; ++nearer)
    for (const Segment& s : scene[nearer])
      if (s.x0 <= x && x <= s.x1) greatest = std::max(greatest, height_of(s, x));
  return greatest;
}

} // namespace

TEST_CASE("a farther list shows where it is above the nearer one") {
  const Segments near{{0, 0, 4, 4, 1}}, far{{0, 3, 4, 0, 2}, {4, 5, 6, 5, 3}};
  const auto clips = exact_clip(std::vector<ExactList>{{near}, {far}});
  REQUIRE(clips.size() == 2);
  CHECK(clips[0].visible == Pieces{{0, 0, 4, 0, 1}});
  CHECK(clips[0].least_horizon == 3); // sky, the segment, sky
  // x = 3 - 3 x / 4 at 12 / 7.
  CHECK(clips[1].visible == Pieces{{0, 0, 12.0 / 7, 0, 3.0 / 7}, {1, 4, 6, 0, 1}});
  CHECK(clips[1].least_horizon == 5);
}

TEST_CASE("occluders raise the horizon undrawn; compared lists leave it") {
  const Segments wall{level(2, 3, 5, 1)}, line{level(0, 10, 1, 2)}, lower{level(0, 10, 0, 3)};
  const auto clips = exact_clip(std::vector<ExactList>{
      {wall, Role::occluder}, {line, Role::compared}, {lower, Role::compared}, {lower}});
  CHECK(clips[0].visible.empty());
  const Pieces beside{{0, 0, 2, 0, 0.2}, {0, 3, 10, 0.3, 1}};
  for (std::size_t i = 1; i < 4; ++i) CHECK(clips[i].visible == beside);
  CHECK(clips[2].least_horizon == 3);
  CHECK(clips[3].least_horizon == 5);
}

TEST_CASE("what lies on the horizon is drawn once") {
  const Segments ridge{level(0, 4, 1, 1)}, same{level(1, 6, 1, 2)}, whole{level(0, 6, 1, 3)};
  SECTION("a tie with what is drawn is not drawn") {
    const auto clips = exact_clip(std::vector<ExactList>{{ridge}, {same}, {whole}});
    CHECK(clips[1].visible == Pieces{{0, 4, 6, 0.6, 1}});
    CHECK(clips[2].visible.empty());
    CHECK(clips[2].least_horizon == 4); // the tied part stays the nearer segment's
  }
  SECTION("a tie with an occluder is drawn, and then not again") {
    const auto clips = exact_clip(std::vector<ExactList>{
        {ridge, Role::occluder}, {same, Role::compared}, {whole, Role::compared}, {whole}});
    CHECK(clips[1].visible == Pieces{{0, 1, 6, 0, 1}});
    CHECK(clips[1].least_horizon == 3); // one source, though from 1 on it is inked
    // Beyond the ridge a compared line has left no trace.
    CHECK(clips[2].visible == Pieces{{0, 0, 1, 0, 1.0 / 6}, {0, 4, 6, 4.0 / 6, 1}});
    CHECK(clips[3].visible == Pieces{{0, 4, 6, 4.0 / 6, 1}});
  }
  SECTION("touching in a point is no tie") {
    const Segments peak{{0, 0, 2, 2, 1}, {2, 2, 4, 0, 2}}, over{level(0, 4, 2, 3)};
    CHECK(exact_clip(std::vector<ExactList>{{peak}, {over}})[1].visible == Pieces{{0, 0, 4, 0, 1}});
  }
  SECTION("one ulp above is above") {
    const double above = std::nextafter(1.0, 2.0);
    const Segments tilted{{0, 1, 4, above, 4}};
    CHECK(exact_clip(std::vector<ExactList>{{ridge}, {tilted}})[1].visible ==
          Pieces{{0, 0, 4, 0, 1}});
  }
}

TEST_CASE("ends are the nearest doubles to the true ones") {
  // y = x crosses y = 1 - 9 x at 1 / 10, which is nearer to the double above it than to that below.
  for (const double steep : {2.0, 6.0, 9.0, 12.0}) {
    const Segments up{{0, 0, 1, 1, 1}}, down{{0, 1, 1, 1 - steep, 2}};
    const auto visible = exact_clip(std::vector<ExactList>{{up}, {down}})[1].visible;
    CHECK(visible == Pieces{{0, 0, 1 / (1 + steep), 0, 1 / (1 + steep)}});
  }
}

TEST_CASE("by the definition of the horizon: lattice and other random scenes") {
  for (const SceneKind& kind : scene_kinds()) {
    if (kind.y_scale > 10 || kind.y_scale < 0.1 || kind.offset != 0) continue;
    std::size_t visible = 0, hidden = 0;
    for (std::uint64_t seed = 1; seed <= last_seed(40); ++seed) {
      const FlatScene scene = flat_scene(kind, seed);
      std::vector<ExactList> lists;
      for (const auto& segments : scene) lists.push_back({segments});
      const auto clips = exact_clip(lists);
      for (std::size_t list = 0; list < scene.size(); ++list)
        for (std::uint32_t number = 0; number < scene[list].size(); ++number) {
          const Segment& s = scene[list][number];
          CAPTURE(kind.name, seed, list, number);
          // Between visible pieces the segment is hidden, or tied with something drawn.
          const auto ask = [&](double begin, double end, bool above) {
            for (const double share : {0.01, 0.25, 0.5, 0.75, 0.99}) {
              const double x = begin + share * (end - begin);
              const double over = height_of(s, x) - greatest_in_front(scene, list, x);
              REQUIRE((above ? over >= -1e-13 : over <= 1e-13));
            }
            ++(above ? visible : hidden);
          };
          double from = s.x0;
          for (const Piece& piece : clips[list].visible) {
            if (piece.segment != number) continue;
            REQUIRE(piece.x_begin < piece.x_end);
            REQUIRE(std::abs(s.x0 + piece.t_begin * (s.x1 - s.x0) - piece.x_begin) <= 1e-13);
            REQUIRE(std::abs(s.x0 + piece.t_end * (s.x1 - s.x0) - piece.x_end) <= 1e-13);
            if (from < piece.x_begin) ask(from, piece.x_begin, false);
            ask(piece.x_begin, piece.x_end, true);
            from = piece.x_end;
          }
          if (from < s.x1) ask(from, s.x1, false);
        }
    }
    CAPTURE(kind.name, visible, hidden);
    CHECK(visible > enough(1000));
    CHECK(hidden > enough(1000));
  }
}

TEST_CASE("the least horizon is what `clip` keeps with collapse, and not what it keeps without") {
  const SceneKind smooth = scene_kinds()[1];
  for (std::uint64_t seed = 1; seed <= last_seed(20); ++seed) {
    CAPTURE(seed);
    const FlatScene scene = flat_scene(smooth, seed);
    std::vector<ExactList> lists;
    for (const auto& segments : scene) lists.push_back({segments});
    const auto clips = exact_clip(lists);
    Horizon collapsed = initial_horizon(), fragmented = initial_horizon();
    ClipWorkspace workspace;
    for (std::size_t list = 0; list < scene.size(); ++list) {
      clip(scene[list], collapsed, {Role::drawn_occluder, {}, true}, workspace);
      clip(scene[list], fragmented, {Role::drawn_occluder, {}, false}, workspace);
      REQUIRE(clips[list].least_horizon == collapsed.size());
    }
    REQUIRE(clips.back().least_horizon < fragmented.size());
  }
}

} // namespace orograph::exact_clip_test
