// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/clip.hpp"
#include "horizon/clip_line.hpp"
#include "tests/catch.hpp"
#include "tests/horizon/flat_scenes.hpp"

#include <algorithm>
#include <cmath>

using namespace orograph;

namespace {

double greatest(const FlatScene& scene, double x) {
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& list : scene)
    for (const Segment& s : list)
      if (s.x0 <= x && x <= s.x1)
        most = std::max(most, s.y0 + (x - s.x0) / (s.x1 - s.x0) * (s.y1 - s.y0));
  return most;
}

} // namespace

TEST_CASE("the parts of a line that are above a horizon, by asking everything in it") {
  for (const SceneKind& kind : scene_kinds()) {
    if (kind.y_scale > 10 || kind.offset != 0) continue;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      Random random(seed);
      const FlatScene scene = flat_scene(kind, seed);
      Horizon horizon = initial_horizon();
      ClipWorkspace workspace;
      for (const auto& list : scene) clip(list, horizon, {Role::occluder, {}, true}, workspace);
      for (int i = 0; i < 40; ++i) {
        Vec2 a{random.between(-2, 20), random.between(0, 2 * kind.y_scale)};
        Vec2 b{random.between(-2, 20), random.between(0, 2 * kind.y_scale)};
        if (kind.lattice)
          a = {std::round(a.x), std::round(a.y)}, b = {std::round(b.x), std::round(b.y)};
        if (i % 4 == 0) b.x = a.x;
        if (a == b) continue;
        CAPTURE(kind.name, seed, a.x, a.y, b.x, b.y);
        std::vector<LinePart> parts;
        clip_line(a, b, horizon, parts);
        double last = 0;
        for (const LinePart& part : parts) {
          REQUIRE(part.begin >= last);
          REQUIRE(part.end > part.begin);
          REQUIRE(part.end <= 1);
          last = part.end;
        }
        for (int k = 0; k < 30; ++k) {
          const double t = random.between(0, 1);
          const double above = a.y + t * (b.y - a.y) - greatest(scene, a.x + t * (b.x - a.x));
          if (std::abs(above) <= 1e-9 * (1 + kind.y_scale)) continue;
          const bool shown = std::any_of(parts.begin(), parts.end(), [&](const LinePart& part) {
            return part.begin <= t && t <= part.end;
          });
          REQUIRE(shown == (above > 0));
        }
      }
    }
  }
}

TEST_CASE("a line from right to left has the same parts, counted from its other end") {
  Horizon horizon = initial_horizon();
  ClipWorkspace workspace;
  clip(std::vector<Segment>{{0, 0, 1, 2, 1}, {1, 2, 2, 0, 2}}, horizon, {Role::occluder, {}, true},
       workspace);
  std::vector<LinePart> there, back;
  clip_line({-1, 1}, {3, 1}, horizon, there);
  clip_line({3, 1}, {-1, 1}, horizon, back);
  REQUIRE(there.size() == 2);
  REQUIRE(back.size() == 2);
  CHECK(std::abs(there[0].end - 0.375) <= 1e-15);
  CHECK(std::abs(back[0].end - 0.375) <= 1e-15);
  CHECK(std::abs(there[1].begin - 0.625) <= 1e-15);
}
