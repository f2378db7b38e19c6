// SPDX-License-Identifier: GPL-3.0-or-later
// Shadows against their definitions, point by point along lines, in long double.
#include "solids/shadow.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <utility>

using namespace orograph;

namespace {

using Real = long double;

const std::uint64_t kLines = last_seed(10000);
constexpr int kPlaces = 25;
// Places closer to the other answer than this aren't asked: shares are rounded.
constexpr Real kClose = 1e-9L;

View random_view(Random& random) {
  View view;
  view.projection =
      random.pick({Projection::perspective, Projection::orthographic, Projection::oblique});
  if (view.is_perspective()) {
    view.eye_z_m = random.between(-3, 6);
    view.near_m = 0.01;
  } else if (view.projection == Projection::orthographic) {
    const double elevation = random.pick({0.0, 0.3, 1.0, 1.5, std::acos(0.0)});
    view.y_per_z = std::cos(elevation);
    view.y_per_v = std::sin(elevation);
  } else {
    view.x_per_v = random.between(-0.7, 0.7);
    view.y_per_v = random.between(0.1, 0.7);
  }
  return view;
}

// On a small lattice half of the time.
Vec3 random_point(Random& random, bool lattice, double nearest) {
  if (lattice)
    return {double(random.whole(-3, 3)), double(random.whole(1, 6)), double(random.whole(-2, 3))};
  return {random.between(-3, 3), random.between(nearest, 6), random.between(-2, 3)};
}

// Along the ray, away from the viewer.
Vec3 ray_at(const SightRays& rays, Vec3 p) {
  return rays.parallel ? rays.from : p - rays.from;
}

struct Answer {
  bool hidden;
  Real margin; // how far it is from the other answer
};

// Whether the ray to p meets the triangle before p: Cramer's rule for p - s d = a + i b + j c.
Answer behind_triangle(const SightRays& rays, const std::array<Vec3, 3>& t, Vec3 p) {
  const Vec3 d = ray_at(rays, p), e = t[1] - t[0], f = t[2] - t[0], o = p - t[0];
  const auto det = [](Vec3 a, Vec3 b, Vec3 c) {
    return Real{a.x} * (Real{b.y} * c.z - Real{b.z} * c.y) -
           Real{a.y} * (Real{b.x} * c.z - Real{b.z} * c.x) +
           Real{a.z} * (Real{b.x} * c.y - Real{b.y} * c.x);
  };
  const Real all = det(d, e, f);
  const Real s = det(o, e, f) / all, i = det(d, o, f) / all, j = det(d, e, o) / all;
  const Real inside = std::min({s, i, j, 1 - i - j, rays.parallel ? 1 : 1 - s});
  return {inside > 0, std::abs(inside)};
}

// Whether an edge's point at p's X is in front of p, and higher in the picture.
Answer below_edge(const View& view, Vec3 left, Vec3 right, Vec3 p) {
  const auto plane = [&](Vec3 q) {
    return view.is_perspective()
               ? std::pair<Real, Real>{Real{q.x} / q.y, (Real{q.z} - view.eye_z_m) / q.y}
               : std::pair<Real, Real>{Real{q.x} + Real{view.x_per_v} * q.y,
                                       Real{view.y_per_z} * q.z + Real{view.y_per_v} * q.y};
  };
  const auto [xl, yl] = plane(left);
  const auto [xr, yr] = plane(right);
  const auto [x, y] = plane(p);
  const Real share = (x - xl) / (xr - xl), high = yl + share * (yr - yl);
  const Real depth = view.is_perspective() ? 1 / ((1 - share) / left.y + share / right.y)
                                           : left.y + share * (Real{right.y} - left.y);
  const Real margin = std::min({share, 1 - share, p.y - depth, high - y});
  return {margin > 0, std::abs(margin)};
}

Answer under_triangle(const std::array<Vec3, 3>& t, Vec3 p) {
  const auto cross2 = [](Vec3 a, Vec3 b) { return Real{a.x} * b.y - Real{a.y} * b.x; };
  const Real all = cross2(t[1] - t[0], t[2] - t[0]);
  const Real b = cross2(p - t[0], t[2] - t[0]) / all, c = cross2(t[1] - t[0], p - t[0]) / all;
  const Real height = t[0].z + b * (Real{t[1].z} - t[0].z) + c * (Real{t[2].z} - t[0].z);
  const Real margin = std::min({b, c, 1 - b - c, height - p.z});
  return {margin > 0, std::abs(margin)};
}

struct Tally {
  int hidden = 0, seen = 0;
};

template <class Ask>
void ask_along(const Shadow& shadow, Vec3 from, Vec3 to, const Ask& ask, Tally& tally) {
  const std::optional<Share> share = hidden_share(shadow, from, to);
  for (int i = 0; i <= kPlaces; ++i) {
    const double t = static_cast<double>(i) / kPlaces;
    const Answer right = ask(from + t * (to - from));
    if (!(right.margin > kClose)) continue;
    const bool hidden = share && share->begin <= t && t <= share->end;
    CAPTURE(t, right.margin, from.x, from.y, from.z, to.x, to.y, to.z);
    REQUIRE(hidden == right.hidden);
    ++(hidden ? tally.hidden : tally.seen);
  }
}

} // namespace

TEST_CASE("a triangle's shadow is what rays meet behind it", "[slow]") {
  Tally tally;
  for (std::uint64_t n = 0; n < kLines; ++n) {
    Random random(static_cast<std::uint64_t>(n));
    const View view = random_view(random);
    const SightRays rays = sight_rays(view);
    const bool lattice = random.chance(0.5);
    std::array<Vec3, 3> corners;
    // Parts of it may be beside the eye or behind it.
    for (Vec3& corner : corners) corner = random_point(random, lattice, -2);
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double facing = dot(normal, rays.parallel ? -1.0 * rays.from : rays.from - corners[0]);
    if (std::abs(facing) < 1e-6) continue;
    if (facing < 0) std::swap(corners[1], corners[2]);
    const Shadow shadow = triangle_shadow(rays, corners, {7, 3, 5}, 0);
    ask_along(
        shadow, random_point(random, lattice, 0.01), random_point(random, lattice, 0.01),
        [&](Vec3 p) { return behind_triangle(rays, corners, p); }, tally);
  }
  CHECK(tally.hidden > enough(10000));
  CHECK(tally.seen > enough(10000));
}

TEST_CASE("an edge of the ground hides what is behind it and lower in the picture", "[slow]") {
  Tally tally;
  for (std::uint64_t n = 0; n < kLines; ++n) {
    Random random(static_cast<std::uint64_t>(n) + 1000000);
    const View view = random_view(random);
    if (view.y_per_z < 0.01) continue; // straight down
    const bool lattice = random.chance(0.5);
    Vec3 left = random_point(random, lattice, 0.02), right = random_point(random, lattice, 0.02);
    const double x_left = project(view, {left.x, left.y, left.z}).x,
                 x_right = project(view, {right.x, right.y, right.z}).x;
    if (std::abs(x_left - x_right) < 1e-6) continue;
    if (x_left > x_right) std::swap(left, right);
    const Shadow shadow = edge_shadow(view, sight_rays(view), left, right, 0);
    ask_along(
        shadow, random_point(random, lattice, 0.02), random_point(random, lattice, 0.02),
        [&](Vec3 p) { return below_edge(view, left, right, p); }, tally);
  }
  CHECK(tally.hidden > enough(10000));
  CHECK(tally.seen > enough(10000));
}

TEST_CASE("what is buried is below a triangle of the ground", "[slow]") {
  Tally tally;
  for (std::uint64_t n = 0; n < kLines; ++n) {
    Random random(static_cast<std::uint64_t>(n) + 2000000);
    const bool lattice = random.chance(0.5);
    std::array<Vec3, 3> corners;
    for (Vec3& corner : corners) corner = random_point(random, lattice, 1);
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (std::abs(normal.z) < 1e-3) continue;
    if (normal.z < 0) std::swap(corners[1], corners[2]);
    const Shadow shadow = buried_under(corners, 0);
    ask_along(
        shadow, random_point(random, lattice, 1), random_point(random, lattice, 1),
        [&](Vec3 p) { return under_triangle(corners, p); }, tally);
  }
  CHECK(tally.hidden > enough(10000));
  CHECK(tally.seen > enough(10000));
}

TEST_CASE("neighbouring shadows meet in the same share") {
  int met = 0;
  for (std::uint64_t n = 0; n < kLines; ++n) {
    Random random(static_cast<std::uint64_t>(n) + 3000000);
    const View view = random_view(random);
    const SightRays rays = sight_rays(view);
    std::array<Vec3, 4> p;
    for (Vec3& corner : p) corner = random_point(random, false, 1);
    const auto light = [&](const std::array<Vec3, 3>& t) {
      const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
      return dot(normal, rays.parallel ? -1.0 * rays.from : rays.from - t[0]) > 0;
    };
    if (!light({p[0], p[1], p[2]}) || !light({p[1], p[0], p[3]})) continue;
    const Vec3 from = random_point(random, false, 6) + Vec3{0, 9, 0},
               to = random_point(random, false, 6) + Vec3{0, 9, 0};
    const auto a = hidden_share(triangle_shadow(rays, {p[0], p[1], p[2]}, {0, 1, 2}, 0), from, to);
    const auto b = hidden_share(triangle_shadow(rays, {p[1], p[0], p[3]}, {1, 0, 3}, 0), from, to);
    if (!a || !b) continue;
    const auto [first, second] = a->begin < b->begin ? std::pair(*a, *b) : std::pair(*b, *a);
    if (std::abs(first.end - second.begin) > 1e-9) continue; // past another edge
    CAPTURE(n);
    CHECK(first.end == second.begin);
    ++met;
  }
  CHECK(met > enough(50));
}
