// SPDX-License-Identifier: GPL-3.0-or-later
// The ray walk over a TIN against every triangle's section by the plane of the ray, in long double,
// against the walk over a grid, and against cases reckoned by hand.
#include "dem/approximate/tin_of_grid.hpp"
#include "reference/judge.hpp"
#include "reference/ray_walk.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/notched_tin.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orograph::tin_ray_walk_test {
namespace {

View looking(Projection projection, Vec2 forward, double descent_deg, Vec2 depth_origin_m,
             double eye_z_m = 0) {
  View view;
  view.projection = projection;
  view.forward = forward;
  view.right = {forward.y, -forward.x};
  view.depth_origin_m = depth_origin_m;
  view.eye_z_m = eye_z_m;
  view.elevation = Angle::degrees(descent_deg);
  view.y_per_v = sin(view.elevation);
  view.y_per_z = cos(view.elevation);
  view.near_m = 0.5;
  return view;
}

struct Place {
  long double w, z; ///< depth and height, in the plane of the ray
};

// The greatest Y strictly in front of p: `certain` of what is met by more than `slack` (metres),
// `possible` of what is met within it. They are equal, and the truth, for a slack of 0.
struct Bounds {
  long double certain = -kInfinity, possible = -kInfinity;
};

Bounds by_triangles(const Tin& tin, const View& view, ProfilePoint p, long double slack) {
  const bool perspective = view.is_perspective();
  const auto y_of = [&](Place at) {
    return perspective ? (at.z - view.eye_z_m) / at.w : at.z * view.y_per_z + at.w * view.y_per_v;
  };
  const long double begin = perspective ? static_cast<long double>(view.near_m) : -kInfinity;
  const long double own = y_of({p.v, p.z});
  const long double length = std::hypot(static_cast<long double>(p.u), p.v);
  const auto aside = [&](ProfilePoint q) -> long double {
    if (!perspective) return static_cast<long double>(q.u) - p.u;
    return (static_cast<long double>(q.u) * p.v - static_cast<long double>(p.u) * q.v) / length;
  };
  Bounds bounds;
  for (const auto& triangle : tin.triangles) {
    std::vector<Place> certain, possible;
    for (std::size_t k = 0; k < 3; ++k) {
      const ProfilePoint a = to_profile_frame(view, tin.vertices_m[triangle[k]]),
                         b = to_profile_frame(view, tin.vertices_m[triangle[(k + 1) % 3]]);
      const long double at_a = aside(a), at_b = aside(b);
      if (at_a == 0) certain.push_back({a.v, a.z});
      if (std::abs(at_a) <= slack) possible.push_back({a.v, a.z});
      if (at_a * at_b >= 0) continue;
      const long double s = at_a / (at_a - at_b);
      const Place met{a.v + s * (static_cast<long double>(b.v) - a.v),
                      a.z + s * (static_cast<long double>(b.z) - a.z)};
      possible.push_back(met);
      if (std::min(std::abs(at_a), std::abs(at_b)) > slack) certain.push_back(met);
    }
    // Of a wall along the ray only the vertices are certain: what is above a point within it is the
    // same picture.
    const bool edge_on = certain.size() == 3;
    const auto take = [&](const std::vector<Place>& places, long double& greatest,
                          long double apart) {
      const std::size_t ends = places.size();
      // Between two ends of the section: at the near plane, and just in front of p where that is
      // above it.
      for (std::size_t i = 0; i < ends; ++i)
        for (std::size_t k = 0; k < ends; ++k) {
          const Place &f = places[i], &t = places[k];
          if (!(f.w < t.w)) continue;
          const auto at = [&](long double w) {
            return Place{w, f.z + (w - f.w) / (t.w - f.w) * (t.z - f.z)};
          };
          if (f.w < begin && t.w > begin && begin < p.v)
            greatest = std::max(greatest, y_of(at(begin)));
          if (!(edge_on && apart > 0) && f.w < p.v - apart && t.w >= p.v + apart &&
              y_of(at(p.v)) > own + apart)
            greatest = std::max(greatest, y_of(at(p.v)));
        }
      for (std::size_t i = 0; i < ends; ++i)
        if (places[i].w >= begin && places[i].w < p.v - apart)
          greatest = std::max(greatest, y_of(places[i]));
    };
    // A crossing's depth is rounded, if only in long double.
    const long double depth_slack = slack + 1e-12L;
    take(certain, bounds.certain, depth_slack);
    take(possible, bounds.possible, -depth_slack);
  }
  return bounds;
}

struct Sums {
  int asked = 0, hidden = 0, bare = 0, sharp = 0; ///< sharp: bounds that are equal
};

void check(const Tin& tin, const View& view, const TinRayWalk& walk, ProfilePoint p,
           long double slack, Sums& sums) {
  if (view.is_perspective() && p.v < 2 * view.near_m) return;
  const InFront front = walk.in_front(p);
  const Bounds bounds = by_triangles(tin, view, p, slack);
  CAPTURE(p.u, p.v, p.z, static_cast<double>(bounds.certain), static_cast<double>(bounds.possible),
          front.greatest_y, front.rounding);
  REQUIRE(front.rounding > 0);
  REQUIRE(front.greatest_y_apart <= front.greatest_y);
  REQUIRE(front.greatest_y >= bounds.certain - front.rounding);
  REQUIRE(front.greatest_y <= bounds.possible + front.rounding);
  ++sums.asked;
  sums.sharp += bounds.certain == bounds.possible;
  sums.bare += front.greatest_y == -kInfinity;
  sums.hidden += front.greatest_y > project(view, p).y + front.rounding;
  if (front.greatest_y > -kInfinity) REQUIRE(front.at_depth_m <= p.v);
}

// Vertices, places on edges and anywhere on a triangle, walls too, on the surface or above it.
// `exact`: of numbers that double precision holds, where vertices are whole.
ProfilePoint random_point(Random& random, const Tin& tin, const View& view, bool exact) {
  const auto& t = tin.triangles[static_cast<std::size_t>(
      random.whole(0, static_cast<int>(tin.triangles.size()) - 1))];
  double a = random.share(), b = random.share() * (1 - a);
  const int kind = random.whole(0, exact ? 2 : 3);
  if (exact) a = 0.25 * random.whole(1, 3);
  if (kind == 0) a = b = 0;
  if (kind == 1) b = 0;
  if (kind == 2) a = 0.5, b = 0.25; // exact in whole coordinates
  const Vec3 o = tin.vertices_m[t[0]];
  Vec3 at = o + a * (tin.vertices_m[t[1]] - o) + b * (tin.vertices_m[t[2]] - o);
  if (random.chance(0.2)) at.z += random.pick({-3.0, 3.0});
  return to_profile_frame(view, at);
}

MadeTin random_wish(Random& random) {
  MadeTin wanted;
  wanted.columns = random.whole(2, 9);
  wanted.rows = random.whole(2, 9);
  wanted.step_m = 8;
  wanted.missing = random.pick({0.0, 0.1, 0.5});
  wanted.walls = random.pick({0.0, 0.5, 1.0});
  wanted.shuffled = random.chance(0.5);
  return wanted;
}

void report(const Sums& sums) {
  WARN(sums.asked << " asked, " << sums.hidden << " hidden, " << sums.bare
                  << " with nothing in front, " << sums.sharp << " exactly known");
  CHECK(sums.asked > enough(10000));
  CHECK(sums.hidden > sums.asked / 20);
  CHECK(sums.sharp > sums.asked / 4);
}

// From the south: ground at height 0 up to y = 0, a wall up to `top`, ground there from y = 0 on.
Tin step_up(double top) {
  Tin tin;
  tin.vertices_m = {{-4, -4, 0},  {4, -4, 0},  {4, 0, 0},   {-4, 0, 0},
                    {-4, 0, top}, {4, 0, top}, {4, 4, top}, {-4, 4, top}};
  tin.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 2, 5}, {3, 5, 4}, {4, 5, 6}, {4, 6, 7}};
  tin.neighbours = neighbours_by_sorting(tin.triangles);
  return tin;
}

} // namespace

TEST_CASE("the walk over a TIN finds what its triangles' sections have, from anywhere") {
  Sums sums;
  for (std::uint64_t seed = 1; seed <= last_seed(600); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Tin tin = made_tin(random, random_wish(random));
    if (tin.triangles.empty()) continue;
    const Vec2 forward = direction_of_azimuth(
        Angle::degrees(random.chance(0.3) ? 45.0 * random.whole(0, 7) : random.between(0, 360)));
    const View view =
        looking(random.chance(0.5) ? Projection::perspective : Projection::orthographic, forward,
                random.pick({0.0, 10.0, 37.5, 80.0, 90.0}),
                {random.between(-40, 100), random.between(-40, 100)}, random.between(-5, 80));
    const TinRayWalk walk(tin, view);
    for (int i = 0; i < 40; ++i)
      check(tin, view, walk, random_point(random, tin, view, false), 1e-10L, sums);
  }
  report(sums);
}

TEST_CASE("rays through vertices, along edges and along walls, exactly") {
  Sums sums;
  for (std::uint64_t seed = 1; seed <= last_seed(1200); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    MadeTin wanted = random_wish(random);
    wanted.whole = true;
    wanted.moved = random.pick({0.0, 0.0, 0.2});
    Tin tin = made_tin(random, wanted);
    if (tin.triangles.empty()) continue;
    if (random.chance(0.5)) add_notches(tin, random, 0.3);
    const Vec2 forward = random.pick({Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}});
    View view = looking(Projection::orthographic, forward, 0, {});
    if (random.chance(0.3)) view.y_per_v = 0.75; // any steepness does
    const TinRayWalk walk(tin, view);
    for (int i = 0; i < 30; ++i)
      check(tin, view, walk, random_point(random, tin, view, true), 0, sums);
  }
  report(sums);
}

TEST_CASE("over a grid and over its triangles, the same") {
  std::size_t asked = 0, hidden = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(400); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const GridLattice lattice =
        turned_lattice(random.whole(2, 12), random.whole(2, 12), {8, random.pick({8.0, 5.0})},
                       seed % 2 ? random.between(-3, 3) : 0);
    const Grid grid = made_grid(random, lattice, {0, 40, random.pick({0.0, 0.2}), false, true});
    const Tin tin = tin_of(grid);
    if (tin.triangles.empty()) continue;
    const View view =
        looking(random.chance(0.5) ? Projection::perspective : Projection::orthographic,
                direction_of_azimuth(Angle::degrees(random.chance(0.3) ? 90.0 * random.whole(0, 3)
                                                                       : random.between(0, 360))),
                random.pick({0.0, 30.0, 90.0}),
                {random.between(-40, 100), random.between(-100, 40)}, random.between(-5, 60));
    const GridRayWalk on_grid(grid, view);
    const TinRayWalk on_tin(tin, view);
    for (int i = 0; i < 40; ++i) {
      // In the middle of triangles: on a vertex or an edge rounding decides what the ray meets.
      const auto& t = tin.triangles[static_cast<std::size_t>(
          random.whole(0, static_cast<int>(tin.triangles.size()) - 1))];
      const double a = random.between(0.1, 0.6), b = random.between(0.1, 0.3);
      const Vec3 o = tin.vertices_m[t[0]];
      const ProfilePoint p = to_profile_frame(view, o + a * (tin.vertices_m[t[1]] - o) +
                                                        b * (tin.vertices_m[t[2]] - o));
      if (view.is_perspective() && p.v < 2 * view.near_m) continue;
      const InFront g = on_grid.in_front(p), n = on_tin.in_front(p);
      CAPTURE(p.u, p.v, p.z, g.greatest_y, n.greatest_y, g.rounding, n.rounding);
      ++asked;
      hidden += n.greatest_y > project(view, p).y;
      if (g.greatest_y == n.greatest_y) continue; // also where nothing is in front
      REQUIRE(std::abs(g.greatest_y - n.greatest_y) <= g.rounding + n.rounding);
      REQUIRE(std::abs(g.greatest_y_apart - n.greatest_y_apart) <= g.rounding + n.rounding);
    }
  }
  WARN(asked << " asked, " << hidden << " hidden");
  CHECK(asked > enough(5000));
  CHECK(hidden > asked / 10);
}

TEST_CASE("a wall that the eye sees, and one turned away, reckoned by hand") {
  const Tin up = step_up(6), down = step_up(-6);
  SECTION("parallel, level: Y is the height") {
    const View north = looking(Projection::orthographic, {0, 1}, 0, {});
    const TinRayWalk on_up(up, north), on_down(down, north);
    for (const double u : {0.0, 0.3, 4.0, -4.0}) {
      CAPTURE(u);
      // The wall itself, its foot and its top, are behind the ground in front alone.
      for (const double z : {0.0, 3.0, 6.0})
        CHECK(std::abs(on_up.in_front({u, 0, z}).greatest_y) <= 1e-13);
      // Behind the wall: its top.
      CHECK(std::abs(on_up.in_front({u, 2, 6}).greatest_y - 6) <= 1e-13);
      CHECK(std::abs(on_up.in_front({u, 2, 9}).greatest_y - 6) <= 1e-13);
      // Turned away, its top hides all below: at its own depth, and behind.
      for (const double z : {-3.0, -6.0})
        CHECK(std::abs(on_down.in_front({u, 0, z}).greatest_y) <= 1e-13);
      CHECK(std::abs(on_down.in_front({u, 2, -6}).greatest_y) <= 1e-13);
      CHECK(on_up.in_front({u, -4, 0}).greatest_y == -kInfinity);
    }
    CHECK(on_up.in_front({4.001, 2, 6}).greatest_y == -kInfinity);
  }
  SECTION("in perspective: the ground at the foot of a wall that rises is seen over nothing") {
    // The eye 14 m south of the wall and 3 m up. Y of the ground's near border is -3 / 10; just in
    // front of the wall it is -3 / 14, which the wall's own foot has.
    const View view = looking(Projection::perspective, {0, 1}, 0, {0, -14}, 3);
    const TinRayWalk walk(up, view);
    CHECK(walk.in_front({0, 14, 0}).greatest_y <= -3 / 14.0 + 1e-15);
    CHECK(std::abs(walk.in_front({0, 16, 6}).greatest_y - 3 / 14.0) <= 1e-15);
    // Turned away: the ground in front ends at -3 / 14, above all of the wall.
    const TinRayWalk behind(down, view);
    CHECK(std::abs(behind.in_front({0, 14, -2}).greatest_y - -3 / 14.0) <= 1e-15);
    CHECK(std::abs(behind.in_front({0, 17, -6}).greatest_y - -3 / 14.0) <= 1e-15);
  }
  SECTION("edge-on, along the wall's line") {
    // From the west, along y = 0: both grounds' borders and the wall between them.
    const View east = looking(Projection::orthographic, {1, 0}, 0, {});
    const TinRayWalk walk(up, east);
    CHECK(walk.in_front({0, 4, 0}).greatest_y == 6);
    CHECK(walk.in_front({1e-6, 4, 0}).greatest_y == 6 - 6); // u is to the right: the south
    CHECK(walk.in_front({-1e-6, 4, 6}).greatest_y == 6);
    CHECK(walk.in_front({0, -4, 0}).greatest_y == -kInfinity);
  }
}

TEST_CASE("straight over an edge, a hair beside it, rounding is as small as anywhere") {
  // Level ground with an edge from (-1, -0.5) to (1, 0.5), which the eye stands over.
  Tin tin;
  tin.vertices_m = {{-1, -0.5, 0}, {1, 0.5, 0}, {0, 50, 0}, {0, -50, 0}};
  tin.triangles = {{0, 1, 2}, {1, 0, 3}};
  for (const double beside_m : {0.0, 1e-10, -1e-10, 1e-7}) {
    CAPTURE(beside_m);
    const View view = looking(Projection::perspective, {0, 1}, 0, {0.3, 0.15 + beside_m}, 60);
    const InFront front = TinRayWalk(tin, view).in_front({-0.05, 20, 0});
    CHECK(std::abs(front.greatest_y - -60 / 0.5) < 1e-6); // at the near plane
    CHECK(front.rounding < 1e-9);
  }
}

// The eye stands over the top of a wall and looks along it, edge-on: whether the ground beyond its
// top hides its foot is a matter of rounding.
TEST_CASE("the foot of a wall that is seen edge-on may be hidden or not") {
  Tin tin;
  const Vec2 eye{-679960, -159920};
  for (const Vec3 at :
       {Vec3{0, 0, 3}, {-8, -1, 32}, {-8, -9, 32}, {0, 0, -22}, {-8, -1, 24}, {1, 7, 32}})
    tin.vertices_m.push_back({eye.x + at.x, eye.y + at.y, at.z});
  tin.triangles = {{0, 1, 2}, {4, 1, 3}, {3, 1, 0}, {5, 4, 3}};
  const double length = std::hypot(39, 8);
  const View view = looking(Projection::perspective, {-39 / length, 8 / length}, 0, eye, 4.7);
  const Surface surface = tin;
  const Judge judge(surface, view, {});
  const auto at = [&](std::size_t vertex) {
    return to_profile_frame(view, tin.vertices_m[vertex]);
  };
  for (const double t : {0.5, 0.8, 0.84, 0.851}) {
    CAPTURE(t);
    CHECK(judge.verdict({at(4), at(3)}, t, true, true) == Verdict::tied);
    CHECK(judge.verdict({at(4), at(3)}, t, true, false) == Verdict::hidden);
    // Well behind the ground over the wall's top there's no doubt.
    const ProfilePoint aside{at(4).u - 0.1, at(4).v - 0.1, at(4).z}, near = at(3);
    CHECK(judge.verdict({aside, {near.u - 0.1, near.v + 0.6, near.z}}, t, true, true) ==
          Verdict::hidden);
  }
}

} // namespace orograph::tin_ray_walk_test
