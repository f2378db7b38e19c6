// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in front of an eye, by definition: every triangle is cut by the upright plane of the
// direction, in long double, and the highest of all that is nearer counts.
#include "profiles/sight_lines.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/asked_of_seeds.hpp"
#include "tests/support/made_earth_grid.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/made_tin.hpp"
#include "tests/support/notched_tin.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace orograph::sight_lines_test {
namespace {

using Real = long double;
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

struct Corner {
  Real along, aside, z;
  Real off_m = 0; ///< by which a rounding aside moves it along
};
using Corners = std::array<ProfilePoint, 3>;

std::vector<Corners> triangles_in_frame(const Surface& surface, const View& view) {
  std::vector<Corners> out;
  if (const Grid* grid = std::get_if<Grid>(&surface)) {
    for (const GridTriangle& t : triangles_of(*grid)) {
      Corners& corners = out.emplace_back();
      for (std::size_t i = 0; i < 3; ++i)
        corners[i] = to_profile_frame(view, grid->vertex_m(t.vertices[i]));
    }
    return out;
  }
  const Tin& tin = std::get<Tin>(surface);
  for (const auto& triangle : tin.triangles) {
    Corners& corners = out.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = to_profile_frame(view, tin.vertices_m[triangle[i]]);
  }
  return out;
}

// What is found of all triangles. Places that rounding may put on either side of the eye or of the
// distance are left out of `least`, and are in `most`.
struct Found {
  Real least = -kInfinity, most = -kInfinity;              ///< slopes
  Real ground_sure = -kInfinity, ground_most = -kInfinity; ///< without walls along the look, with
};

Found by_definition(const std::vector<Corners>& triangles, Real eye_z, Vec2 direction,
                    Real distance_m, Real rounding_m) {
  Found found;
  for (const Corners& triangle : triangles) {
    std::array<Corner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [u, v, z] = triangle[i];
      corners[i] = {Real(direction.x) * u + Real(direction.y) * v,
                    Real(direction.x) * v - Real(direction.y) * u, z};
    }
    // A wall along the look: where there is no ground beside its top it may be met or not.
    const bool is_along = std::ranges::all_of(
        corners, [&](const Corner& corner) { return std::abs(corner.aside) <= rounding_m; });
    std::vector<Corner> section; // its ends, or more in the same line
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner &a = corners[i], &b = corners[(i + 1) % 3];
      if (std::abs(a.aside) <= rounding_m) section.push_back(a);
      if (!(std::abs(a.aside) > rounding_m && std::abs(b.aside) > rounding_m)) continue;
      if ((a.aside < 0) == (b.aside < 0)) continue;
      const Real t = a.aside / (a.aside - b.aside);
      section.push_back({a.along + t * (b.along - a.along), 0, a.z + t * (b.z - a.z),
                         rounding_m * std::abs((b.along - a.along) / (b.aside - a.aside))});
    }
    for (const Corner& at : section) {
      const Real slope = (at.z - eye_z) / at.along;
      // An edge that is nearly along the look is crossed here or there.
      if (!is_along && at.along > 8 * (rounding_m + at.off_m) &&
          at.along + 8 * at.off_m < distance_m - 2 * rounding_m)
        found.least = std::max(found.least, slope);
      if (at.along > 2 * rounding_m && at.along - 8 * at.off_m < distance_m + 2 * rounding_m)
        found.most = std::max(found.most, slope);
    }
    for (const Corner& a : section)
      for (const Corner& b : section) {
        if (!(a.along <= distance_m + rounding_m && b.along >= distance_m - rounding_m)) continue;
        const bool is_wide = b.along - a.along > 4 * rounding_m;
        const Real t = is_wide ? (distance_m - a.along) / (b.along - a.along) : 0;
        for (const Real z : {a.z + t * (b.z - a.z), is_wide ? a.z + t * (b.z - a.z) : b.z}) {
          if (!is_along) found.ground_sure = std::max(found.ground_sure, z);
          found.ground_most = std::max(found.ground_most, z);
        }
      }
  }
  return found;
}

View looking_north(Vec2 at, double eye_z_m) {
  View view;
  view.depth_origin_m = at;
  view.eye_z_m = eye_z_m;
  return view;
}

std::vector<BorderEdge> border_of(const Surface& surface) {
  if (const Grid* grid = std::get_if<Grid>(&surface)) return border_edges(*grid, false);
  return border_edges(std::get<Tin>(surface));
}

struct Sums {
  std::uint64_t seed = 0;
  int asked = 0, in_front = 0, bare = 0, on_ground = 0, beside = 0;
  int vague = 0; ///< along an edge, to rounding
};

// Everything in units of some `size_m`, the terrain's.
void check(const Surface& surface, const View& view, Random& random, double size_m, Sums& sums) {
  const auto triangles = triangles_in_frame(surface, view);
  if (triangles.empty()) return;
  const std::vector<BorderEdge> border = border_of(surface);
  const SightLines lines(surface, border, view);
  const Real rounding_m = lines.rounding_m();
  for (int i = 0; i < 24; ++i) {
    // Towards vertices, points of edges, of triangles, beside them, and along the axes.
    const Corners& corners = triangles[static_cast<std::size_t>(
        random.whole(0, static_cast<int>(triangles.size()) - 1))];
    Vec2 target{corners[0].u, corners[0].v};
    const double s = random.share(), t = random.share() * (1 - s);
    const int kind = random.whole(0, 4);
    if (kind == 1)
      target = target + s * Vec2{corners[1].u - corners[0].u, corners[1].v - corners[0].v};
    if (kind == 2)
      target = target + s * Vec2{corners[1].u - corners[0].u, corners[1].v - corners[0].v} +
               t * Vec2{corners[2].u - corners[0].u, corners[2].v - corners[0].v};
    if (kind == 3) target = random.between(0.5, 1.5) * target;
    if (kind == 4)
      target =
          size_m * random.share() * direction_of_azimuth(Angle::degrees(45.0 * random.whole(0, 7)));
    const double distance_m = std::hypot(target.x, target.y);
    if (!(distance_m > 1e-3 * size_m)) continue;
    const Vec2 direction{target.x / distance_m, target.y / distance_m};
    const bool all = random.chance(0.2);
    const double up_to_m = all ? std::numeric_limits<double>::infinity() : distance_m;
    const Found right = by_definition(triangles, view.eye_z_m, direction, up_to_m, rounding_m);
    // A vertex that far aside is in the plane or not.
    const Found wide = by_definition(triangles, view.eye_z_m, direction, up_to_m, 2 * rounding_m),
                narrow =
                    by_definition(triangles, view.eye_z_m, direction, up_to_m, 0.5L * rounding_m);
    const SightLine sight = lines.up_to(direction, up_to_m);
    const Real least = std::min({right.least, wide.least, narrow.least}),
               most = std::max({right.most, wide.most, narrow.most});
    const Real slack =
        4 * Real(sight.rounding) + (sight.highest ? 1e-13L * (1 + std::abs(Real(sight.slope))) : 0);
    INFO("seed " << sums.seed << " towards " << target.x << ", " << target.y << " from "
                 << view.depth_origin_m.x << ", " << view.depth_origin_m.y << ", " << view.eye_z_m
                 << ": " << sight.slope << ", by definition " << double(least) << " to "
                 << double(most) << ", rounding " << sight.rounding);
    ++sums.asked;
    REQUIRE(sight.highest.has_value() == (sight.slope > -kInfinity));
    REQUIRE(Real(sight.slope) >= least - slack);
    REQUIRE(Real(sight.slope) <= most + slack);
    ++(sight.highest ? sums.in_front : sums.bare);
    sums.vague += sight.rounding > 1e-6 * (1 + std::abs(sight.slope));
    if (all) continue;
    if (!sight.ground) {
      // Beside the surface, or no farther within than a rounding.
      REQUIRE(narrow.ground_sure == -kInfinity);
      ++sums.beside;
      continue;
    }
    if (wide.ground_most == -kInfinity) { // on the border, by more than one rounding beside it
      ++sums.vague;
      continue;
    }
    ++sums.on_ground;
    // The top of what is there; the steepest triangles of these scenes rise by 1e5 in a metre.
    const Real off = 1e5L * rounding_m + 4 * Real(sight.ground->rounding_m);
    REQUIRE(Real(sight.ground->z_m) <= wide.ground_most + off);
    REQUIRE(Real(sight.ground->z_m) >= std::min(narrow.ground_sure, right.ground_sure) - off);
  }
}

} // namespace

TEST_CASE("Over grids on a map plane the highest in front is that of all triangles") {
  const Sums all = asked_of_seeds<Sums>(2000, [](Random& random, Sums& sums) {
    const int columns = random.whole(2, 9), rows = random.whole(2, 9);
    GridLattice lattice{columns, rows};
    if (random.chance(0.5))
      lattice = turned_lattice(columns, rows, {random.pick({1.0, 30.0}), random.pick({1.0, 25.0})},
                               random.pick({0.0, 0.5, 1.0, random.between(0, 6)}));
    GridHeights heights{0, random.pick({0.0, 3.0, 100.0})};
    heights.whole = random.chance(0.5);
    heights.in_double = random.chance(0.5);
    heights.missing = random.pick({0.0, 0.1, 0.4});
    const Grid grid = made_grid(random, lattice, heights);
    const double size_m =
        std::hypot(columns * length(lattice.column_step_m), rows * length(lattice.row_step_m));
    // On a vertex, on a line of the lattice, within, beside and far away.
    Vec2 at = grid.plane().position_m(random.whole(0, columns - 1), random.whole(0, rows - 1));
    if (random.chance(0.3)) at = at + random.share() * lattice.column_step_m;
    if (random.chance(0.3)) at = at + random.share() * lattice.row_step_m;
    if (random.chance(0.2)) at = at + 3 * size_m * Vec2{random.share() - 0.5, random.share() - 0.5};
    View view = looking_north(at, random.pick({-10.0, 1.0, 50.0, 200.0, random.between(0, 100)}));
    view.exaggeration = random.pick({1.0, 2.0});
    if (random.chance(0.5)) view.drop = {random.share() * 1e-2, 0, random.share() * 1e-2};
    check(grid, view, random, size_m, sums);
  });
  CHECK(all.in_front >= enough(20000));
  CHECK(all.bare >= enough(3000));
  CHECK(all.on_ground >= enough(10000));
  CHECK(all.beside >= enough(3000));
  CHECK(all.vague <= all.asked / 500);
}

TEST_CASE("Over TINs with walls and holes the highest in front is that of all triangles") {
  const Sums all = asked_of_seeds<Sums>(1000, [](Random& random, Sums& sums) {
    MadeTin wanted;
    wanted.columns = random.whole(2, 8);
    wanted.rows = random.whole(2, 8);
    wanted.moved = random.pick({0.0, 0.2});
    wanted.whole = random.chance(0.5);
    wanted.high_m = random.pick({0.0, 50.0});
    wanted.missing = random.pick({0.0, 0.15});
    wanted.walls = random.pick({0.0, 0.7});
    wanted.shuffled = random.chance(0.5);
    Tin tin = made_tin(random, wanted);
    if (tin.triangles.empty()) return;
    if (wanted.whole && random.chance(0.5)) add_notches(tin, random, 0.3);
    const double size_m = 10 * std::hypot(wanted.columns, wanted.rows);
    Vec2 at = plan_m(tin, static_cast<std::uint32_t>(
                              random.whole(0, static_cast<int>(tin.vertices_m.size()) - 1)));
    if (random.chance(0.5)) at = at + Vec2{random.between(-10, 10), random.between(-10, 10)};
    if (random.chance(0.2)) at = at + 3 * size_m * Vec2{random.share() - 0.5, random.share() - 0.5};
    View view = looking_north(at, random.pick({0.0, 60.0, 200.0, random.between(0, 100)}));
    if (random.chance(0.5)) view.drop = {random.share() * 1e-3, 0, random.share() * 1e-3};
    check(tin, view, random, size_m, sums);
  });
  CHECK(all.in_front >= enough(10000));
  CHECK(all.on_ground >= enough(6000));
  CHECK(all.vague <= all.asked / 500);
}

TEST_CASE("Over grids in degrees the highest in front is that of all triangles") {
  const Sums all = asked_of_seeds<Sums>(600, [](Random& random, Sums& sums) {
    MadeEarth made = random_earth(random, 9);
    // The eye is above the frame's origin, which is about the grid.
    made.origin_lon_deg =
        made.west_deg + random.between(-0.2, 1.2) * (made.columns - 1) * made.lon_step_deg;
    made.origin_lat_deg =
        std::clamp(made.north_deg - random.between(-0.2, 1.2) * (made.rows - 1) * made.lat_step_deg,
                   -85.0, 85.0);
    if (random.chance(0.3)) {
      made.origin_lon_deg = made.west_deg + random.whole(0, made.columns - 1) * made.lon_step_deg;
      made.origin_lat_deg = made.north_deg - random.whole(0, made.rows - 1) * made.lat_step_deg;
    }
    const Grid grid = made_earth_grid(random, made);
    if (leaning_triangles(grid) > 0) return; // what the ellipsoid turns over isn't a surface
    const double size_m =
        111e3 * std::hypot(made.columns * made.lon_step_deg, made.rows * made.lat_step_deg);
    View view = looking_north({0, 0}, random.pick({100.0, 5000.0, random.between(0, 1e4)}));
    if (random.chance(0.5)) view.drop = {-1e-8, 0, -1e-8};
    check(grid, view, random, size_m, sums);
  });
  CHECK(all.in_front >= enough(4000));
  CHECK(all.on_ground >= enough(2000));
  CHECK(all.vague <= all.asked / 100);
}

TEST_CASE("Of places as high the farthest is the skyline, and the terrain's end is told") {
  // A plane seen edge-on, and behind it a slope that falls away.
  const Surface surface = Grid{2, 4, PlaneLattice{{-1, 4}, {2, 0}, {0, -1}},
                               std::vector<double>{-9, -9, 3, 3, 2, 2, 1, 1}};
  const View view = looking_north({0, 0}, 0);
  const SightLines lines(surface, border_of(surface), view);
  const SightLine sight = lines.skyline({0, 1});
  REQUIRE(sight.highest);
  CHECK(sight.slope == 1);
  CHECK(sight.highest->distance_m == 3);
  CHECK_FALSE(sight.at_border);
  const Surface rising =
      Grid{2, 3, PlaneLattice{{-1, 3}, {2, 0}, {0, -1}}, std::vector<double>{9, 9, 2, 2, 1, 1}};
  const SightLine end = SightLines(rising, border_of(rising), view).skyline({0, 1});
  REQUIRE(end.highest);
  CHECK(end.slope == 3);
  CHECK(end.at_border);
  CHECK_FALSE(lines.skyline({0, -1}).highest);
}

} // namespace orograph::sight_lines_test
