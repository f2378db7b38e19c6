// SPDX-License-Identifier: GPL-3.0-or-later
// The cut against its definition: every triangle's section by the plane, on its own, in long
// double.
#include "dem/approximate/tin_of_grid.hpp"
#include "profiles/cut_grid.hpp"
#include "profiles/cut_mesh.hpp"
#include "profiles/mesh_walk.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/tin_sections.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/notched_tin.hpp"
#include "tests/support/random.hpp"

#include <chrono>
#include <cmath>
#include <limits>

namespace orograph::cut_tin_test {
namespace {

const TriangleSet no_level;

struct Asked {
  std::size_t places = 0, gaps = 0, walls = 0, turned = 0, in_plane = 0;
};

// How exact places and heights are.
struct Slack {
  long double u, z;
};

void check_places(Random& random, const TinSections& expected, const Profile& profile,
                  const TriangleSet& level, Slack slack, Asked& asked) {
  long double low = HUGE_VALL, high = -HUGE_VALL;
  for (const TinSection& s : expected.ground) {
    low = std::min(low, s.left.u);
    high = std::max(high, s.right.u);
  }
  for (int i = 0; i < 40 && low <= high; ++i) {
    long double u = 0;
    if (i % 2) {
      u = low - 1 + (high - low + 2) * static_cast<long double>(random.share());
    } else { // within a triangle, perhaps a narrow one
      const TinSection& s = expected.ground[static_cast<std::size_t>(
          random.whole(0, static_cast<int>(expected.ground.size()) - 1))];
      u = s.left.u + (s.right.u - s.left.u) * static_cast<long double>(random.between(0.1, 0.9));
    }
    std::vector<std::pair<const TinSection*, long double>> holding; // with the height there
    bool in_front = false, doubt = false;
    for (const auto* list : {&expected.ground, &expected.walls})
      for (const TinSection& s : *list) {
        doubt = doubt || std::abs(u - s.left.u) <= slack.u || std::abs(u - s.right.u) <= slack.u;
        // An upright triangle in the plane may be there with any of its heights.
        if (!(s.left.u < u && u < s.right.u) || (list == &expected.walls && !s.in_plane)) continue;
        if (list == &expected.walls) doubt = doubt || !in_front;
        const long double t = (u - s.left.u) / (s.right.u - s.left.u);
        holding.push_back({&s, s.left.z + t * (s.right.z - s.left.z)});
        in_front = in_front || s.in_front;
      }
    if (doubt) continue;
    Span span = Span::gap;
    long double z = 0;
    for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
      const long double left = profile.u_m[k], right = profile.u_m[k + 1];
      if (!(left < u && u < right)) continue;
      span = profile.after[k];
      z = profile.z_m[k] + (u - left) / (right - left) *
                               (static_cast<long double>(profile.z_m[k + 1]) - profile.z_m[k]);
    }
    CAPTURE(static_cast<double>(u), static_cast<double>(z), holding.size());
    ++asked.places;
    asked.gaps += holding.empty();
    REQUIRE(span != Span::wall);
    REQUIRE((span == Span::gap) == holding.empty());
    if (holding.empty()) continue;
    bool right_height = false, is_level = false;
    for (const auto& [s, height] : holding) {
      asked.in_plane += s->in_plane;
      // An edge is level if either triangle is, but for a wall's.
      const bool ground =
          s >= expected.ground.data() && s < expected.ground.data() + expected.ground.size();
      if (ground && std::abs(height - z) <= slack.z)
        is_level = is_level || (!level.empty() && level.has(s->triangle));
      // Where a wall stands in the plane, it is the height of the ground in front.
      if (!in_front || s->in_front) right_height = right_height || std::abs(height - z) <= slack.z;
    }
    REQUIRE(right_height);
    REQUIRE((span == Span::level) == is_level);
  }
}

void check_walls(const TinSections& expected, const Profile& profile, const View& view, Slack slack,
                 Asked& asked) {
  // Every way up or down is a seen wall's.
  for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
    if (profile.after[k] != Span::wall) continue;
    REQUIRE(profile.u_m[k] == profile.u_m[k + 1]);
    const long double middle =
        0.5L * (static_cast<long double>(profile.z_m[k]) + profile.z_m[k + 1]);
    bool found = false;
    for (const TinSection& s : expected.walls)
      found = found || (std::abs(s.left.u - profile.u_m[k]) <= slack.u &&
                        std::min(s.left.z, s.right.z) - slack.z <= middle &&
                        middle <= std::max(s.left.z, s.right.z) + slack.z &&
                        expected.facing(view, s.triangle) > -1e-12L);
    CAPTURE(profile.u_m[k], profile.z_m[k], profile.z_m[k + 1]);
    REQUIRE(found);
  }
  // Every wall that the plane crosses is there just if it is seen. A rounding beside a vertex,
  // walls and ground that meet there are all at one place.
  if (expected.passes_beside_vertex(slack.u)) return;
  for (const TinSection& s : expected.walls) {
    if (s.in_plane || std::abs(s.right.u - s.left.u) > slack.u ||
        std::abs(s.right.z - s.left.z) <= 4 * slack.z)
      continue;
    const long double facing = expected.facing(view, s.triangle);
    if (std::abs(facing) <= 1e-12L) continue;
    const long double middle = 0.5L * (s.left.z + s.right.z);
    // At a vertex one wall may be seen and the next one turned away.
    const bool doubt =
        std::any_of(expected.walls.begin(), expected.walls.end(), [&](const TinSection& o) {
          return &o != &s && std::abs(o.left.u - s.left.u) <= 2 * slack.u &&
                 (expected.facing(view, o.triangle) > 0) != (facing > 0);
        });
    if (doubt) continue;
    bool found = false;
    for (std::size_t k = 0; k + 1 < profile.size(); ++k)
      found = found ||
              (profile.after[k] == Span::wall && std::abs(s.left.u - profile.u_m[k]) <= slack.u &&
               (profile.z_m[k] <= middle) != (profile.z_m[k + 1] <= middle));
    CAPTURE(static_cast<double>(s.left.u), static_cast<double>(s.left.z),
            static_cast<double>(s.right.z), static_cast<double>(facing));
    REQUIRE(found == (facing > 0));
    ++(facing > 0 ? asked.walls : asked.turned);
  }
}

double reach_of(const Tin& tin, const View& view) {
  double reach = 1;
  for (const Vec3& v : tin.vertices_m)
    reach = std::max({reach, std::abs(v.x), std::abs(v.y), std::abs(v.z),
                      length(Vec2{v.x, v.y} - view.depth_origin_m)});
  return reach;
}

void check_cuts(Random& random, const Tin& tin, const View& view, Asked& asked) {
  TriangleSet level;
  if (random.chance(0.5)) {
    level = TriangleSet(tin.triangles.size());
    for (std::size_t t = 0; t < tin.triangles.size(); ++t)
      if (random.chance(0.5)) level.add(t);
  }
  const TinCutter cutter(tin, view, level);
  const double near = cutter.nearest_m(), far = cutter.farthest_m();
  std::vector<double> depths{near, far, std::nextafter(near, far), std::nextafter(far, near)};
  for (int i = 0; i < 4; ++i) {
    const double vertex =
        to_profile_frame(view, tin.vertices_m[static_cast<std::size_t>(
                                   random.whole(0, static_cast<int>(tin.vertices_m.size()) - 1))])
            .v;
    depths.insert(depths.end(), {vertex, std::nextafter(vertex, near), std::nextafter(vertex, far),
                                 random.between(near, far)});
  }
  const double reach = reach_of(tin, view);
  const Slack slack{64 * std::numeric_limits<double>::epsilon() * reach,
                    1e5 * std::numeric_limits<double>::epsilon() * reach};
  Profile profile;
  for (const double depth : depths) {
    CAPTURE(depth, depth - near, far - depth, view.forward.x, view.forward.y);
    cutter.cut(depth, profile);
    REQUIRE(profile.depth_m == depth);
    const std::size_t count = profile.size();
    REQUIRE((profile.z_m.size() == count && profile.after.size() == count));
    if (count > 0) REQUIRE(profile.after.back() == Span::gap);
    for (std::size_t k = 0; k + 1 < count; ++k) REQUIRE(profile.u_m[k] <= profile.u_m[k + 1]);
    const TinSections expected(tin, view, depth);
    check_places(random, expected, profile, level, slack, asked);
    check_walls(expected, profile, view, slack, asked);
  }
}

MadeTin random_wish(Random& random) {
  MadeTin wanted;
  wanted.columns = random.whole(2, 9);
  wanted.rows = random.whole(2, 9);
  wanted.missing = random.pick({0.0, 0.0, 0.05, 0.3, 0.7});
  wanted.walls = random.pick({0.0, 0.5, 1.0});
  wanted.shuffled = random.chance(0.5);
  return wanted;
}

View random_view(Random& random, Vec2 direction) {
  View view = looking(direction, {}, random.pick({1.0, 1.5}));
  view.elevation = Angle::degrees(random.pick({0.0, 20.0, 70.0}));
  view.y_per_v = sin(view.elevation);
  view.y_per_z = cos(view.elevation);
  return view;
}

void report(const Asked& asked) {
  WARN(asked.places << " places, " << asked.gaps << " in gaps, " << asked.in_plane
                    << " on edges in the plane, " << asked.walls << " walls seen, " << asked.turned
                    << " turned away");
}

} // namespace

TEST_CASE("a TIN is cut as its triangles are, from any azimuth") {
  Asked asked;
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    MadeTin wanted = random_wish(random);
    const double offset = random.pick({0.0, 100.0, 1e6});
    wanted.first_vertex_m = {random.between(-1, 1) * offset, random.between(-1, 1) * offset};
    const Tin tin = made_tin(random, wanted);
    if (tin.triangles.empty()) continue;
    const Angle azimuth =
        Angle::degrees(random.chance(0.5) ? 45.0 * random.whole(-8, 8) : random.between(0, 360));
    View view = random_view(random, direction_of_azimuth(azimuth));
    if (random.chance(0.3)) {
      view.projection = Projection::perspective;
      view.eye_z_m = random.between(-50, 150);
      view.depth_origin_m = {random.between(-200, 200), random.between(-200, 200)};
    }
    check_cuts(random, tin, view, asked);
  }
  report(asked);
  CHECK(asked.places > enough(100000));
  CHECK(asked.walls > enough(1000));
  CHECK(asked.turned > enough(1000));
}

// Whole coordinates seen along an axis, or whole directions: depths are exact, so planes meet
// vertices and hold edges, walls and needles exactly.
TEST_CASE("planes through vertices and along edges and walls, exactly", "[slow]") {
  Asked asked;
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    MadeTin wanted = random_wish(random);
    wanted.whole = true;
    wanted.step_m = 8;
    wanted.moved = random.pick({0.0, 0.0, 0.2});
    wanted.first_vertex_m = {8.0 * random.whole(-9, 9), 8.0 * random.whole(-9, 9)};
    Tin tin = made_tin(random, wanted);
    if (tin.triangles.empty()) continue;
    if (random.chance(0.5)) add_notches(tin, random, 0.3);
    // Not of unit length, so that diagonals lie in planes exactly as well.
    const Vec2 direction = random.pick({Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1},
                                        Vec2{1, 1}, Vec2{-1, 1}, Vec2{2, 1}, Vec2{-1, -3}});
    check_cuts(random, tin, random_view(random, direction), asked);
  }
  report(asked);
  CHECK(asked.in_plane > enough(10000));
  CHECK(asked.walls > enough(1000));
  CHECK(asked.turned > enough(1000));
}

TEST_CASE("a grid's profile and that of its triangles as a TIN are one, bit for bit") {
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const GridLattice lattice =
        turned_lattice(random.whole(2, 12), random.whole(2, 12), {10, random.pick({10.0, 7.0})},
                       random.pick({0.0, 0.785398163397448, random.between(-0.7, 0.7)}));
    const Grid grid =
        made_grid(random, lattice, {0, 50, random.pick({0.0, 0.1, 0.4}), false, true});
    const Tin tin = tin_of(grid);
    if (tin.triangles.empty()) continue;
    const View view = looking(direction_of_azimuth(
        Angle::degrees(random.chance(0.5) ? 45.0 * random.whole(0, 7) : random.between(0, 360))));
    const GridCutter of_grid(grid, view, no_level);
    const TinCutter of_tin(tin, view, no_level);
    Profile whole, profile;
    for (int i = 0; i < 20; ++i) {
      const ProfilePoint vertex =
          to_profile_frame(view, tin.vertices_m[static_cast<std::size_t>(random.whole(
                                     0, static_cast<int>(tin.vertices_m.size()) - 1))]);
      const double depth =
          i % 2 ? vertex.v : random.between(of_tin.nearest_m(), of_tin.farthest_m());
      // Where rounding decides whether the plane grazes the nearest edge, or cuts.
      if (depth != of_grid.nearest_m() && depth < of_grid.nearest_m() + 1e-9) continue;
      CAPTURE(depth);
      of_grid.cut(depth, whole);
      of_tin.cut(depth, profile);
      const auto spans = [](const Profile& p) {
        std::vector<std::array<double, 4>> out;
        for (std::size_t k = 0; k + 1 < p.size(); ++k)
          if (p.after[k] != Span::gap && p.u_m[k] < p.u_m[k + 1])
            out.push_back({p.u_m[k], p.z_m[k], p.u_m[k + 1], p.z_m[k + 1]});
        return out;
      };
      REQUIRE(spans(whole) == spans(profile));
    }
  }
}

TEST_CASE("a wall across the plane is a way straight up if the eye sees it, otherwise a gap") {
  // Low ground in the west, high ground in the east, the wall between them runs from the south-west
  // to the north-east: from the south it is turned away, from the north it is seen.
  Tin tin;
  tin.vertices_m = {{-9, -1, 0}, {-1, -1, 0}, {1, 1, 0}, {-9, 1, 0},
                    {-1, -1, 5}, {9, -1, 5},  {9, 1, 5}, {1, 1, 5}};
  tin.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}, {1, 4, 7}, {1, 7, 2}};
  tin.neighbours = neighbours_by_sorting(tin.triangles);
  Profile profile;
  const auto cut_looking = [&](Vec2 direction) {
    TinCutter(tin, looking(direction), no_level).cut(0, profile);
    std::string spans;
    for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
      if (profile.u_m[k] == profile.u_m[k + 1]) CHECK(profile.u_m[k] == 0);
      spans += profile.after[k] == Span::wall ? "w" : profile.after[k] == Span::slope ? "s" : "g";
    }
    return spans;
  };
  const std::string from_south = cut_looking({0, 1}), from_north = cut_looking({0, -1});
  const auto has = [](const std::string& s, char c) { return s.find(c) != std::string::npos; };
  CAPTURE(from_south, from_north);
  CHECK(has(from_south, 'w') != has(from_north, 'w'));
  CHECK(has(from_south, 'g') != has(from_north, 'g'));
  CHECK(has(from_north, 'w'));
}

TEST_CASE("nothing is cut before the TIN, behind it, or at a depth that isn't a number") {
  Random random(1);
  const Tin tin = made_tin(random, {});
  const TinCutter cutter(tin, looking({0, 1}), no_level);
  Profile profile;
  for (const double depth :
       {cutter.nearest_m() - 1e-9, cutter.farthest_m() + 1e-9, std::nan(""), -HUGE_VAL, HUGE_VAL}) {
    cutter.cut(depth, profile);
    CHECK(profile.size() == 0);
  }
}

TEST_CASE("many planes through a large TIN") {
  const int kSide = is_slow_build() ? 200 : 1000, kPlanes = kSide;
  Random random(3);
  const Tin tin = tin_of(made_grid(random, {kSide, kSide, {}, {1, 0}, {0, -1}}, {}));
  const auto begin = std::chrono::steady_clock::now();
  const TinCutter cutter(tin, looking(direction_of_azimuth(Angle::degrees(17))), no_level);
  Profile profile;
  std::size_t vertices = 0;
  for (int i = 0; i < kPlanes; ++i) {
    cutter.cut(cutter.nearest_m() +
                   (i + 0.5) / kPlanes * (cutter.farthest_m() - cutter.nearest_m()),
               profile);
    vertices += profile.size();
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  WARN(kPlanes << " planes, " << vertices << " vertices, " << taken.count() << " s");
  CHECK(vertices > static_cast<std::size_t>(kPlanes * kSide));
}

// Of two walls on an edge one is missing, so that nothing joins the other to the ground.
TEST_CASE("a wall whose place rounds to within the ground beside it is there") {
  const double u = -2.3232210942835896;
  for (const double ground_end : {-6.7, 6.5}) { // to the left of it, or to the right
    for (const double wall : {u, std::nextafter(u, -10), std::nextafter(u, 10)}) {
      CAPTURE(ground_end, u - wall);
      Profile found;
      const auto add = [&](double at, double z, Span after) {
        found.u_m.push_back(at);
        found.z_m.push_back(z);
        found.after.push_back(after);
      };
      add(std::min(u, ground_end), 79, Span::slope);
      add(std::max(u, ground_end), 79, Span::gap);
      add(wall, 61, Span::wall);
      add(wall, 53, Span::gap);
      std::vector<Run> runs{{0, 2, found.u_m[0], found.u_m[1], false}, {2, 4, wall, wall, false}};
      Profile out;
      put_in_order(found, runs, out);
      REQUIRE(out.size() == 4);
      const std::size_t first = ground_end < u ? 2 : 0; // of the wall's
      CHECK(out.after[first] == Span::wall);
      CHECK(out.z_m[first] == 61);
      CHECK(out.z_m[first + 1] == 53);
      CHECK(out.u_m[first] == out.u_m[first + 1]);
      CHECK(std::abs(out.u_m[first] - u) < 1e-15);
      CHECK(std::is_sorted(out.u_m.begin(), out.u_m.end()));
    }
  }
}

} // namespace orograph::cut_tin_test
