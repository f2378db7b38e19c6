// SPDX-License-Identifier: GPL-3.0-or-later
// The reference for visibility among solids, against answers known by construction, and over the
// ground against the ray walk.
#include "dem/height_at.hpp"
#include "reference/ray_walk.hpp"
#include "reference/sight.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/made_solids.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace orograph::sight_test {
namespace {

View looking_north(Projection projection, double descent_deg, double eye_z_m = 0) {
  View view;
  view.projection = projection;
  view.eye_z_m = eye_z_m;
  view.elevation = Angle::degrees(descent_deg);
  if (projection == Projection::orthographic) {
    view.y_per_v = sin(view.elevation);
    view.y_per_z = cos(view.elevation);
  }
  view.near_m = 0.5;
  return view;
}

View cavalier() {
  View view = looking_north(Projection::oblique, 0);
  view.x_per_v = view.y_per_v = std::sqrt(0.5);
  return view;
}

// From the eye 10 m south of the origin, `up` m over height 0.
View from_eye(double up) {
  View view = looking_north(Projection::perspective, 0, up);
  view.depth_origin_m = {0, -10};
  return view;
}

// Square, 2 `half` m wide about the origin, with a vertex each metre.
template <class Height>
Surface ground(int half, const Height& height) {
  Grid grid;
  grid.columns = grid.rows = 2 * half + 1;
  const double away = half;
  grid.lattice = PlaneLattice{{-away, away}, {1, 0}, {0, -1}};
  std::vector<double> heights;
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c) heights.push_back(height(c - away, away - r));
  grid.heights_m = std::move(heights);
  return grid;
}
Surface level(int half) {
  return ground(half, [](double, double) { return 0.0; });
}

StandingSolid box_at(const Solid& box, Vec3 low, Vec3 size) {
  return stand(box, false, [=](Vec3 p) {
    return low + Vec3{p.x * size.x, p.y * size.y, p.z * size.z};
  });
}

enum class Seen { yes, by_ground, by_solid, by_both };

struct Eyes {
  const View& view;
  const Sight& sight;

  Sight::Answer ask(Vec3 ground_m, double slack_m = 0, const Own& own = {}) const {
    return sight.ask(to_profile_frame(view, ground_m), slack_m, own);
  }
  void sees(Vec3 ground_m, Seen seen) const {
    const Sight::Answer answer = ask(ground_m);
    CAPTURE(ground_m.x, ground_m.y, ground_m.z);
    CHECK(answer.by_ground == (seen == Seen::by_ground || seen == Seen::by_both));
    CHECK(answer.by_solid == (seen == Seen::by_solid || seen == Seen::by_both));
    CHECK(!answer.unsure);
  }
};

} // namespace

TEST_CASE("a box on level ground, from ahead") {
  const Surface surface = level(8);
  const Solid box = made_box();
  const std::vector<StandingSolid> solids{box_at(box, {-1, -1, 0}, {2, 2, 3})};
  SECTION("in perspective") {
    const View view = from_eye(1.5);
    const Sight sight(surface, solids, view);
    const Eyes eyes{view, sight};
    eyes.sees({0.2, -1, 1}, Seen::yes);     // its front
    eyes.sees({0.2, 1, 1}, Seen::by_solid); // its back
    eyes.sees({-1, -1, 2}, Seen::yes);      // the edges of its front
    eyes.sees({1, 1, 2}, Seen::by_solid);   // and of its back
    eyes.sees({0.2, 0, 2}, Seen::by_solid); // within it
    eyes.sees({0.2, 4, 2}, Seen::by_solid); // behind it
    eyes.sees({0.2, 4, 10}, Seen::yes);     // over it
    eyes.sees({3, 4, 1}, Seen::yes);        // beside it
    eyes.sees({0, -3, -0.1}, Seen::by_ground);
    eyes.sees({0.2, 1, -0.1}, Seen::by_both);
    // Its shadow's side: at depth 14 it is 14/9 as far out as the front at 9.
    eyes.sees({14 / 9.0 - 0.001, 4, 1}, Seen::by_solid);
    eyes.sees({14 / 9.0 + 0.001, 4, 1}, Seen::yes);
    CHECK(eyes.ask({14 / 9.0, 4, 1}).unsure);
    CHECK(eyes.ask({14 / 9.0 + 0.001, 4, 1}, 0.01).unsure);
    // The line of sight to it meets the front's diagonal, a smooth edge.
    eyes.sees({0, 4, 1.5}, Seen::by_solid);
  }
  SECTION("orthographic, along its top, and from 45 degrees") {
    const View flat = looking_north(Projection::orthographic, 0);
    const Sight along(surface, solids, flat);
    const Eyes low{flat, along};
    CHECK(low.ask({0.3, 0, 3}).unsure);
    low.sees({0.3, 5, 2.999}, Seen::by_solid);
    low.sees({0.3, 5, 3.001}, Seen::yes);
    low.sees({0.3, -1, 3}, Seen::yes); // the front's upper edge
    const View steep = looking_north(Projection::orthographic, 45);
    const Sight from_above(surface, solids, steep);
    const Eyes high{steep, from_above};
    high.sees({0.3, 0, 3}, Seen::yes);
    high.sees({0.3, 3.9, 0.01}, Seen::by_solid);
    high.sees({0.3, 4.1, 0.01}, Seen::yes);
  }
  SECTION("oblique: sideways as far as back") {
    const View view = cavalier();
    const Sight sight(surface, solids, view);
    const Eyes eyes{view, sight};
    eyes.sees({1, 0, 1}, Seen::yes); // rays come from the right, above and the front
    eyes.sees({-1, 0, 1}, Seen::by_solid);
    eyes.sees({-1.3, 1, 1}, Seen::by_solid);
    eyes.sees({1.5, 1, 1}, Seen::yes);
    eyes.sees({0, 0, 3}, Seen::yes);
  }
  SECTION("straight down") {
    const View view = looking_north(Projection::orthographic, 90);
    REQUIRE(view.y_per_z == 0);
    const Sight sight(surface, solids, view);
    const Eyes eyes{view, sight};
    eyes.sees({0.3, 0.2, 3}, Seen::yes);
    eyes.sees({0.3, 0.2, 2}, Seen::by_solid);
    eyes.sees({1.3, 0.2, 2}, Seen::yes);
    eyes.sees({1.3, 0.2, -1}, Seen::by_ground);
    eyes.sees({0.3, 0.2, -1}, Seen::by_both);
    eyes.sees({9, 0.2, -1}, Seen::yes); // beyond the ground's border
    CHECK(eyes.ask({1, 0.2, 1}).unsure);
  }
}

TEST_CASE("a wall of ground hides, and a pit's floor is seen from above it only") {
  const Surface wall = ground(8, [](double, double y) { return y == 2 ? 4.0 : 0.0; });
  const Surface pit =
      ground(8, [](double x, double y) { return std::abs(x) < 3 && std::abs(y) < 3 ? -5.0 : 0.0; });
  SECTION("wall") {
    const View view = from_eye(1);
    const Sight sight(wall, {}, view);
    const Eyes eyes{view, sight};
    eyes.sees({0.3, 1, 1}, Seen::yes);
    eyes.sees({0.3, 2, 3.9}, Seen::by_ground); // within the wall
    eyes.sees({0.3, 5, 1}, Seen::by_ground);
    eyes.sees({0.3, 5, 4.7}, Seen::by_ground); // Y of the top is 3/12, here 3.7/15
    eyes.sees({0.3, 5, 4.8}, Seen::yes);
    CHECK(eyes.ask({0.3, 5, 4.75}).unsure);
    eyes.sees({11, 5, 1}, Seen::yes); // past its end, which is at X = 8 / 12
  }
  SECTION("pit, with a post in it, partly buried, and a slab afloat") {
    const Solid box = made_box();
    const std::vector<StandingSolid> solids{box_at(box, {-0.5, -0.5, -7}, {1, 1, 4}),
                                            box_at(box, {-6, 4, 1}, {12, 2, 0.25})};
    const View flat = looking_north(Projection::orthographic, 0);
    const Sight along(pit, solids, flat);
    Eyes{flat, along}.sees({0.2, -0.5, -3.5}, Seen::by_ground);
    Eyes{flat, along}.sees({0.2, 7, 0.9}, Seen::yes); // under the slab
    Eyes{flat, along}.sees({0.2, 7, 1.1}, Seen::by_solid);
    Eyes{flat, along}.sees({0.2, 7, 1.3}, Seen::yes);
    const View steep = looking_north(Projection::orthographic, 60);
    const Sight from_above(pit, solids, steep);
    const Eyes eyes{steep, from_above};
    eyes.sees({0.2, -0.5, -3.1}, Seen::yes);
    eyes.sees({0.2, -0.5, -4.9}, Seen::by_ground); // the pit's rim
    eyes.sees({0.2, -0.5, -6}, Seen::by_ground);   // buried
    eyes.sees({0.2, 0.5, -6}, Seen::by_both);
    eyes.sees({0.2, 5, 1.25}, Seen::yes);     // the slab's top
    eyes.sees({0.2, 5, 1}, Seen::by_solid);   // its underside
    eyes.sees({0.2, 5, 0.5}, Seen::by_solid); // under it
  }
}

TEST_CASE("ground nearer than the near plane doesn't hide; solids there do") {
  const Surface surface = ground(12, [](double, double y) { return y == -9 ? 3.0 : 0.0; });
  const Solid box = made_box();
  const std::vector<StandingSolid> solids{box_at(box, {1, -9.5, 1}, {1, 0.2, 4})};
  View view = from_eye(2);
  for (const auto& [near_m, seen] : {std::pair{0.5, Seen::by_ground}, {1.9, Seen::yes}}) {
    view.near_m = near_m;
    const Sight sight(surface, solids, view);
    Eyes{view, sight}.sees({0.5, 0, 2}, seen);
    CHECK(sight.ask(to_profile_frame(view, {28, 3, 2.5})).by_solid);
  }
}

TEST_CASE("solids that touch: what is theirs doesn't hide, what is another's can't be told") {
  const Surface surface = level(8);
  const Solid box = made_box();
  const std::vector<StandingSolid> solids{box_at(box, {0, 0, 1}, {1, 1, 1}),
                                          box_at(box, {0, 0, 2}, {1, 1, 1})};
  const View view = looking_north(Projection::orthographic, 30);
  const Sight sight(surface, solids, view);
  const Eyes eyes{view, sight};
  const Vec3 between{0.4, 0, 2}; // on the edges of both
  std::size_t asked = 0;
  for (std::size_t s = 0; s < 2; ++s)
    for (std::size_t e = 0; e < box.edges.size(); ++e) {
      const Vec3 a = solids[s].vertices_m[box.edges[e].from],
                 b = solids[s].vertices_m[box.edges[e].to];
      if (!(a.y == 0 && b.y == 0 && a.z == 2 && b.z == 2)) continue;
      ++asked;
      CHECK(eyes.ask(between, 0, {Own::Which::edge, s, e}).unsure);
    }
  CHECK(asked == 2);
  eyes.sees(between, Seen::yes);
  CHECK(eyes.ask(between, 0, {Own::Which::none}).unsure);
  eyes.sees({0.4, 0.5, 2}, Seen::by_solid); // in the face that they share
  eyes.sees({0.4, 1, 2}, Seen::by_solid);
}

TEST_CASE("over the ground, the same as the ray walk") {
  std::size_t asked = 0, hidden = 0, unsure = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(150); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const GridLattice lattice =
        turned_lattice(random.whole(2, 9), random.whole(2, 9), {8, random.pick({8.0, 5.0})},
                       seed % 2 ? random.between(-3, 3) : 0);
    const Surface surface =
        made_grid(random, lattice, {0, 40, random.pick({0.0, 0.2}), seed % 3 == 0, true});
    View view = looking_north(random.pick({Projection::perspective, Projection::orthographic}),
                              random.pick({0.0, 0.0, 30.0, 80.0}), random.between(-5, 60));
    if (random.chance(0.2)) view = cavalier();
    if (random.chance(0.5)) {
      view.forward = direction_of_azimuth(Angle::degrees(random.between(0, 360)));
      view.right = {view.forward.y, 0 - view.forward.x};
    }
    view.depth_origin_m = {random.between(-40, 100), random.between(-100, 40)};
    const RayWalk walk(surface, view);
    const Sight sight(surface, {}, view);
    for (int i = 0; i < 60; ++i) {
      const Grid& grid = std::get<Grid>(surface);
      const auto number = [&] { return random.whole(0, static_cast<int>(grid.size()) - 1); };
      const Vec3 a = grid.vertex_m(static_cast<std::size_t>(number())),
                 b = grid.vertex_m(static_cast<std::size_t>(number()));
      Vec3 at = a + random.share() * (b - a);
      if (!std::isfinite(at.z)) continue;
      at.z = random.between(-5, 45);
      const ProfilePoint p = to_profile_frame(view, at);
      if (view.is_perspective() && p.v < 2 * view.near_m) continue;
      const auto above = height_at(surface, {at.x, at.y});
      const InFront front = walk.in_front(p);
      const double y = project(view, p).y;
      const SightAnswer verdict = sight.by_ground(p);
      ++asked;
      hidden += verdict.hidden;
      unsure += verdict.unsure;
      CAPTURE(p.u, p.v, p.z, front.greatest_y, y, above.value_or(-1));
      if (verdict.unsure) continue;
      // The walk doesn't know of the ground over a point, which at a border rounding may miss.
      const bool may_be_under = std::ranges::any_of(
          std::array{Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}, [&](Vec2 way) {
            return height_at(surface, Vec2{at.x, at.y} + 1e-9 * way).value_or(at.z) > at.z;
          });
      if (above && *above > at.z)
        CHECK(verdict.hidden);
      else if (!may_be_under &&
               (std::abs(front.greatest_y - y) > front.rounding || std::isinf(front.greatest_y)))
        CHECK(verdict.hidden == (front.greatest_y > y));
    }
  }
  CHECK(asked > enough(5000));
  CHECK(hidden > asked / 4);
  CHECK(hidden < asked / 4 * 3);
  // Rays along rows and columns, on the border.
  CHECK(unsure < asked / 10);
}

} // namespace orograph::sight_test
