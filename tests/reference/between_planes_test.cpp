// SPDX-License-Identifier: GPL-3.0-or-later
// What planes cut away no longer hides, and what they leave does: the ray walk over the kept TIN
// against the sections of all the original triangles, cut to what is between the planes.
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/mesh/keep_within.hpp"
#include "reference/ray_walk.hpp"
#include "tests/catch.hpp"
#include "tests/support/half_spaces.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orograph::between_planes_test {
namespace {

constexpr double kTie = 1e-7;    // of Y; in a parallel view metres
constexpr double kApart = 1e-9;  // metres of depth: within them rounding decides what is in front
constexpr double kNearby = 1e-6; // metres from a plane: such points aren't asked about

View any_view(Random& random) {
  View view;
  view.projection = random.chance(0.6) ? Projection::perspective : Projection::orthographic;
  view.forward = direction_of_azimuth(
      Angle::degrees(random.chance(0.3) ? 45.0 * random.whole(0, 7) : random.between(0, 360)));
  view.right = {view.forward.y, -view.forward.x};
  view.depth_origin_m = {random.between(-60, 120), random.between(-120, 60)};
  view.eye_z_m = random.between(-5, 90);
  view.elevation = Angle::degrees(random.pick({0.0, 12.0, 35.0, 70.0}));
  view.y_per_v = sin(view.elevation);
  view.y_per_z = cos(view.elevation);
  if (random.chance(0.3)) view.x_per_v = random.between(-1, 1);
  view.near_m = 0.5;
  return view;
}

// The greatest Y between the planes that is seen with p up to a depth.
long double greatest_in_front(const Tin& tin, const View& view, std::span<const HalfSpace> spaces,
                              ProfilePoint p, double depth) {
  const bool perspective = view.is_perspective();
  const auto depth_of = [&](LongPoint q) {
    return (q.x - view.depth_origin_m.x) * view.forward.x +
           (q.y - view.depth_origin_m.y) * view.forward.y;
  };
  const auto aside_of = [&](LongPoint q) { // of the vertical plane that holds the ray
    const long double u =
        (q.x - view.depth_origin_m.x) * view.right.x + (q.y - view.depth_origin_m.y) * view.right.y;
    return perspective ? u * p.v - depth_of(q) * p.u : u - p.u + (depth_of(q) - p.v) * view.x_per_v;
  };
  const auto y_of = [&](LongPoint q) {
    return perspective ? (q.z - view.eye_z_m) / depth_of(q)
                       : q.z * view.y_per_z + depth_of(q) * view.y_per_v;
  };
  // Depths from the near plane on, as half-spaces of their own.
  const Vec3 forward{view.forward.x, view.forward.y, 0};
  const double origin = dot(view.forward, view.depth_origin_m);
  std::vector<HalfSpace> all(spaces.begin(), spaces.end());
  all.push_back({forward, origin + depth});
  if (perspective) all.push_back({-1 * forward, -origin - view.near_m});

  long double greatest = -std::numeric_limits<double>::infinity();
  for (const auto& triangle : tin.triangles) {
    std::vector<LongPoint> section;
    for (std::size_t k = 0; k < 3; ++k) {
      const LongPoint a = long_point(tin.vertices_m[triangle[k]]),
                      b = long_point(tin.vertices_m[triangle[(k + 1) % 3]]);
      const long double at_a = aside_of(a), at_b = aside_of(b);
      if ((at_a < 0) == (at_b < 0)) continue;
      const long double s = at_a / (at_a - at_b);
      section.push_back({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)});
    }
    for (const LongPoint q : part_within(section, all)) greatest = std::max(greatest, y_of(q));
  }
  return greatest;
}

Tin any_terrain(Random& random) {
  if (random.chance(0.4)) {
    const GridLattice lattice =
        turned_lattice(random.whole(3, 10), random.whole(3, 10), {9, 11}, random.between(-3, 3));
    return tin_of(made_grid(random, lattice, {0, 40, random.pick({0.0, 0.1}), false, true}));
  }
  MadeTin wanted;
  wanted.columns = random.whole(3, 8);
  wanted.rows = random.whole(3, 8);
  wanted.missing = random.pick({0.0, 0.1});
  wanted.walls = random.pick({0.0, 0.5});
  wanted.shuffled = random.chance(0.5);
  return made_tin(random, wanted);
}

// A front and a back plane, parallel and across the view, tilted or not; or any two planes.
std::vector<HalfSpace> any_planes(const Tin& tin, const View& view, Random& random) {
  const auto through_vertex = [&](Vec3 normal) {
    const Vec3 at = tin.vertices_m[static_cast<std::size_t>(
        random.whole(0, static_cast<int>(tin.vertices_m.size()) - 1))];
    return HalfSpace{normal, dot(normal, at) + random.pick({0.0, random.between(-9, 9)})};
  };
  const double tilt = random.pick({0.0, random.between(-1.5, 1.5)});
  Vec3 normal{view.forward.x, view.forward.y, tilt};
  if (random.chance(0.3))
    normal = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
  HalfSpace back = through_vertex(normal), front = through_vertex(-1 * normal);
  if (-front.offset > back.offset) { // nothing would be left
    const double offset = back.offset;
    back.offset = -front.offset;
    front.offset = -offset;
  }
  if (random.chance(0.2)) return {front};
  return {front, back};
}

} // namespace

TEST_CASE("between a front and a back plane is hidden what is hidden by what they leave") {
  int scenes = 0, asked = 0, hidden = 0, ties = 0, uncovered = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(900); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Tin tin = any_terrain(random);
    if (tin.triangles.empty()) continue;
    const View view = any_view(random);
    const std::vector<HalfSpace> spaces = any_planes(tin, view, random);
    const Tin kept = keep_within(tin, spaces);
    if (kept.triangles.empty()) continue;
    ++scenes;
    const RayWalk walk(kept, view);
    for (int i = 0; i < 60; ++i) {
      const auto& [a, b, c] = tin.triangles[static_cast<std::size_t>(
          random.whole(0, static_cast<int>(tin.triangles.size()) - 1))];
      const double s = random.between(0.02, 0.6), t = random.between(0.02, 0.38);
      const Vec3 o = tin.vertices_m[a];
      const Vec3 at = o + s * (tin.vertices_m[b] - o) + t * (tin.vertices_m[c] - o);
      const ProfilePoint p = to_profile_frame(view, at);
      if (metres_beyond(spaces, long_point(at)) > -kNearby || (view.is_perspective() && p.v < 2))
        continue;
      const InFront front = walk.in_front(p);
      const double own = project(view, p).y;
      const auto by = [&](std::span<const HalfSpace> planes, double depth) {
        return static_cast<double>(greatest_in_front(tin, view, planes, p, depth) - own);
      };
      // What certainly is in front, and what may be: a point on a wall is below the wall's top.
      const double least = by(spaces, p.v - kApart), most = by(spaces, p.v + kApart);
      CAPTURE(p.u, p.v, p.z, own, front.greatest_y, least, most);
      ++asked;
      hidden += least > kTie;
      ties += least <= kTie && most > kTie;
      uncovered += most <= kTie && by({}, p.v - kApart) > kTie;
      if (least > kTie) REQUIRE(front.greatest_y > own + kTie / 2);
      if (most <= kTie) REQUIRE(front.greatest_y < own + 2 * kTie);
    }
  }
  WARN(scenes << " scenes, " << asked << " asked, " << hidden << " hidden, " << ties << " ties, "
              << uncovered << " uncovered by the cut");
  CHECK(scenes > enough(500));
  CHECK(asked > enough(10000));
  CHECK(hidden > asked / 10);
  CHECK(ties < asked / 20);
  CHECK(uncovered > asked / 50);
}

} // namespace orograph::between_planes_test
