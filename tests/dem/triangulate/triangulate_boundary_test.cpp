// SPDX-License-Identifier: GPL-3.0-or-later
// Boundaries and the longest edge by definition: the surface inside stays, outside there is none.
#include "dem/mesh/verify_tin.hpp"
#include "dem/triangulate/triangulate.hpp"
#include "tests/catch.hpp"
#include "tests/dem/triangulate/whole_plane.hpp"

#include <limits>
#include <numbers>
#include <optional>

namespace orograph::triangulate_boundary_test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

BoundaryRing ring_of(const std::vector<Vec2>& places) {
  BoundaryRing ring;
  for (const Vec2 p : places) ring.points_m.push_back({p.x, p.y, kNone});
  return ring;
}

BoundaryRing star(Random& random, Vec2 centre, double least, double greatest, int corners) {
  std::vector<Vec2> places;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners, far = random.between(least, greatest);
    places.push_back(centre + far * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring_of(places);
}

// In an odd number of rings, by a ray to the east.
bool inside(const std::vector<BoundaryRing>& rings, Vec2 p) {
  bool odd = false;
  for (const BoundaryRing& ring : rings)
    for (std::size_t k = 0; k < ring.points_m.size(); ++k) {
      const Vec3 a = ring.points_m[k], b = ring.points_m[(k + 1) % ring.points_m.size()];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      odd ^= a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x;
    }
  return odd;
}

double distance_to_rings(const std::vector<BoundaryRing>& rings, Vec2 p) {
  double least = 1e300;
  for (const BoundaryRing& ring : rings)
    for (std::size_t k = 0; k < ring.points_m.size(); ++k) {
      const Vec3 a = ring.points_m[k], b = ring.points_m[(k + 1) % ring.points_m.size()];
      const Vec2 from{a.x, a.y}, along{b.x - a.x, b.y - a.y};
      const double size = std::max(dot(along, along), 1e-300);
      const double share = std::clamp(dot(p - from, along) / size, 0.0, 1.0);
      least = std::min(least, length(p - from - share * along));
    }
  return least;
}

std::optional<double> height_at(const Tin& tin, Vec2 p) {
  for (const auto& [i, j, k] : tin.triangles) {
    const Vec3 a = tin.vertices_m[i], b = tin.vertices_m[j], c = tin.vertices_m[k];
    const Vec2 u{b.x - a.x, b.y - a.y}, v{c.x - a.x, c.y - a.y}, w{p.x - a.x, p.y - a.y};
    const double s = cross(w, v) / cross(u, v), t = cross(u, w) / cross(u, v);
    if (s >= 0 && t >= 0 && s + t <= 1) return a.z + s * (b.z - a.z) + t * (c.z - a.z);
  }
  return std::nullopt;
}

double area_m2(const Tin& tin) {
  double area = 0;
  for (const auto& [i, j, k] : tin.triangles) {
    const Vec3 u = tin.vertices_m[j] - tin.vertices_m[i], v = tin.vertices_m[k] - tin.vertices_m[i];
    area += 0.5 * (u.x * v.y - u.y * v.x);
  }
  return area;
}

// Heights of random places in a square of this half side, against those of the uncut surface.
void check_cut(Random& random, const Survey& survey, double half_m, int places) {
  Survey uncut = survey;
  uncut.boundary.clear();
  const Tin before = triangulate(uncut).tin;
  const Tin after = triangulate(survey).tin;
  const auto fault = verify(after);
  INFO((fault ? fault->what : ""));
  REQUIRE_FALSE(fault);
  for (int k = 0; k < places; ++k) {
    const Vec2 p{random.between(-half_m, half_m), random.between(-half_m, half_m)};
    if (distance_to_rings(survey.boundary, p) < 1e-7 * half_m) continue;
    const auto expected = inside(survey.boundary, p) ? height_at(before, p) : std::nullopt;
    const auto found = height_at(after, p);
    REQUIRE(expected.has_value() == found.has_value());
    if (expected) REQUIRE(std::abs(*expected - *found) < 1e-6);
  }
}

} // namespace

TEST_CASE("a boundary without heights cuts the surface as scissors do") {
  Random random(1);
  for (int round = 0; round < rounds(60); ++round) {
    Survey survey{random_points(random, random.whole(10, 120), 100), {}, {}, {}};
    for (int k = random.whole(0, 3); k > 0; --k)
      survey.breaklines_m.push_back(random_points(random, 3, 100));
    // Holes, islands in them, rings that cross each other, and some that reach beyond the points.
    survey.boundary = {star(random, {0, 0}, 60, 120, random.whole(3, 20))};
    for (int k = random.whole(0, 3); k > 0; --k)
      survey.boundary.push_back(star(random, {random.between(-40, 40), random.between(-40, 40)}, 5,
                                     random.between(6, 60), random.whole(3, 9)));
    check_cut(random, survey, 130, 200);
  }
}

TEST_CASE("rings on a lattice: along edges, through vertices, touching, crossing themselves") {
  Random random(2);
  int cut = 0;
  for (int round = 0; round < rounds(90); ++round) {
    Survey survey;
    for (int x = -5; x <= 5; ++x)
      for (int y = -5; y <= 5; ++y)
        survey.points_m.push_back({double(x), double(y), random.between(0, 10)});
    for (int rings = random.whole(1, 3); rings > 0; --rings) {
      auto places = random_points(random, random.whole(3, 7), random.chance(0.5) ? 5 : 8);
      for (Vec3& p : places) p = {random.chance(0.2) ? p.x / 2 : p.x, p.y, kNone};
      survey.boundary.push_back({places});
      if (random.chance(0.1)) survey.boundary.push_back({places}); // twice is not at all
    }
    try {
      check_cut(random, survey, 6, 150);
      ++cut;
    } catch (const std::runtime_error&) { // a Tin of nothing: then no place may be inside
      for (int k = 0; k < 500; ++k) {
        const Vec2 p{random.between(-5, 5), random.between(-5, 5)};
        if (distance_to_rings(survey.boundary, p) > 1e-6) REQUIRE_FALSE(inside(survey.boundary, p));
      }
    }
  }
  CHECK(cut > enough(60));
}

TEST_CASE("what a ring keeps has the ring's area") {
  Random random(3);
  Survey survey{random_points(random, 400, 1000), {}, {}, {}};
  survey.points_m.insert(survey.points_m.end(),
                         {{-1000, -1000, 0}, {1000, -1000, 0}, {1000, 1000, 0}, {-1000, 1000, 0}});
  const std::vector<Vec2> ell{{-800, -800}, {700, -750}, {10, 20}, {33, 900}, {-777, 610}};
  const std::vector<Vec2> hole{{-400, -400}, {-300, -410}, {-350, -200}};
  survey.boundary = {ring_of(ell), ring_of(hole)};
  const auto area_of = [](const std::vector<Vec2>& ring) {
    double area = 0;
    for (std::size_t k = 0; k < ring.size(); ++k)
      area += 0.5 * cross(ring[k], ring[(k + 1) % ring.size()]);
    return area;
  };
  CHECK(std::abs(area_m2(triangulate(survey).tin) - (area_of(ell) - area_of(hole))) < 1e-6);
  // Half of it beyond the hull: that isn't added.
  survey.boundary = {ring_of({{0, -500}, {3000, -500}, {3000, 500}, {0, 500}})};
  CHECK(std::abs(area_m2(triangulate(survey).tin) - 1e6) < 1e-6);
  // All of it: nothing changes.
  Survey uncut = survey;
  uncut.boundary.clear();
  survey.boundary = {ring_of({{-2000, -2000}, {2000, -2000}, {2000, 2000}, {-2000, 2000}})};
  CHECK(triangulate(survey).tin == triangulate(uncut).tin);
  CHECK(triangulate(survey).counts.outside == 0);
}

TEST_CASE("a ring with heights is a breakline, and may reach beyond the points") {
  Survey survey{{{4, 4, 9}, {6, 4, 9}, {5, 6, 9}}, {}, {}, {}};
  survey.boundary = {{{{0, 0, 1}, {10, 0, 2}, {10, 10, 3}, {5, 5, 4}, {0, 10, 5}}}};
  const Triangulated result = triangulate(survey);
  CHECK(result.counts.points == 8);
  CHECK_FALSE(verify(result.tin));
  CHECK(std::abs(area_m2(result.tin) - 75) < 1e-9); // without the notch
  CHECK(result.counts.outside > 0);
  CHECK(std::abs(*height_at(result.tin, {5, 0.0001}) - 1.5) < 0.01);
  CHECK_FALSE(height_at(result.tin, {5, 9}));
}

TEST_CASE("long triangles go from the border inwards until none is left there") {
  Random random(4);
  for (int round = 0; round < rounds(100); ++round) {
    Survey survey{random_points(random, random.whole(10, 80), 100), {}, {}, {}};
    if (random.chance(0.5)) survey.boundary = {star(random, {0, 0}, 50, 100, 9)};
    if (random.chance(0.3)) survey.boundary.push_back(star(random, {0, 0}, 10, 40, 7));
    const Triangulated whole_one = triangulate(survey);
    const Tin& tin = whole_one.tin;
    std::vector<char> kept(tin.triangles.size(), 1);
    const double longest = random.between(15, 90);
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t t = 0; t < kept.size(); ++t) {
        bool border = false, is_long = false;
        for (int k = 0; k < 3; ++k) {
          const std::uint32_t next = tin.neighbours[t][k];
          const Vec3 along =
              tin.vertices_m[tin.triangles[t][k]] - tin.vertices_m[tin.triangles[t][(k + 1) % 3]];
          border = border || next == kNoTriangle || !kept[next];
          is_long = is_long || std::hypot(along.x, along.y) > longest;
        }
        if (!kept[t] || !border || !is_long) continue;
        kept[t] = 0;
        changed = true;
      }
    }
    survey.max_edge_m = longest;
    const auto stay = std::count(kept.begin(), kept.end(), 1);
    if (stay == 0) {
      CHECK_THROWS(triangulate(survey));
      continue;
    }
    const Triangulated peeled = triangulate(survey);
    CHECK(peeled.tin.triangles.size() == std::size_t(stay));
    CHECK(peeled.counts.beyond_max_edge == kept.size() - std::size_t(stay));
    CHECK(peeled.counts.outside == whole_one.counts.outside);
    CHECK_FALSE(verify(peeled.tin));
    const auto at = [&](const Tin& of, std::size_t t, int k) {
      return of.vertices_m[of.triangles[t][k]];
    };
    std::vector<std::array<double, 6>> expected, found;
    const auto corners = [&](const Tin& of, std::size_t t) {
      std::array<Vec3, 3> p{at(of, t, 0), at(of, t, 1), at(of, t, 2)};
      std::sort(p.begin(), p.end(),
                [](Vec3 a, Vec3 b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
      return std::array<double, 6>{p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y};
    };
    for (std::size_t t = 0; t < kept.size(); ++t)
      if (kept[t]) expected.push_back(corners(tin, t));
    for (std::size_t t = 0; t < peeled.tin.triangles.size(); ++t)
      found.push_back(corners(peeled.tin, t));
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    CHECK(expected == found);
  }
}

} // namespace orograph::triangulate_boundary_test
