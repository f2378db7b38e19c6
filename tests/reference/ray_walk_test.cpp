// SPDX-License-Identifier: GPL-3.0-or-later
// The ray walk against hand-reckoned cases and against the surface sampled densely along the ray.
#include "dem/height_at.hpp"
#include "reference/ray_walk.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace orograph::ray_walk_test {
namespace {

constexpr double kNear_m = 0.5;     // in perspective
constexpr double kDiameter_m = 100; // more than that of any grid here
constexpr double kHole = std::numeric_limits<double>::quiet_NaN();

// A view that looks towards an azimuth; the window plays no part here.
View looking(Projection projection, double azimuth_deg, double descent_deg, Vec2 depth_origin_m,
             double eye_z_m = 0) {
  View view;
  view.projection = projection;
  view.forward = direction_of_azimuth(Angle::degrees(azimuth_deg));
  view.right = {view.forward.y, -view.forward.x};
  view.depth_origin_m = depth_origin_m;
  view.eye_z_m = eye_z_m;
  view.elevation = Angle::degrees(descent_deg);
  view.y_per_v = sin(view.elevation);
  view.y_per_z = cos(view.elevation);
  view.near_m = kNear_m;
  return view;
}

// Vertices 1 m apart, (0, 0) in the south-west, heights by column and row as listed from the north.
Grid square_grid(int columns, std::vector<double> heights) {
  const int rows = static_cast<int>(heights.size()) / columns;
  return {columns, rows, PlaneLattice{{0, rows - 1.0}, {1, 0}, {0, -1}}, std::move(heights)};
}

Grid heights_by(const GridLattice& lattice, const std::function<double(int, int)>& height) {
  Grid grid{lattice.columns, lattice.rows,
            PlaneLattice{lattice.first_vertex_m, lattice.column_step_m, lattice.row_step_m},
            std::vector<double>()};
  std::vector<double> heights;
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c) heights.push_back(height(c, r));
  grid.heights_m = std::move(heights);
  return grid;
}

// The place at depth w on the ray of p.
ProfilePoint on_ray(const View& view, ProfilePoint p, double w) {
  return {view.is_perspective() ? p.u / p.v * w : p.u + view.x_per_v * (p.v - w), w, 0};
}
std::optional<double> surface_y(const Grid& grid, const View& view, ProfilePoint place) {
  const Vec3 ground = to_ground_m(view, place);
  const auto height_m = height_at(grid, {ground.x, ground.y});
  if (!height_m) return std::nullopt;
  return project(view, {place.u, place.v, *height_m * view.exaggeration}).y;
}

// The same where the place may be off the surface's border by rounding.
double surface_y_beside(const Grid& grid, const View& view, ProfilePoint place) {
  for (const double du : {0.0, -1e-9, 1e-9})
    for (const double dv : {0.0, -1e-9, 1e-9})
      if (const auto y = surface_y(grid, view, {place.u + du, place.v + dv, 0})) return *y;
  return kHole;
}

struct Sums {
  int asked = 0, hidden = 0, bare = 0; ///< bare: with nothing in front
};

// For the surface's point at a ground place: whatever a dense sampling of the ray finds, the walk
// has found, and where it says that the surface is higher than sampled, the surface is that high.
void check(const Grid& grid, const View& view, Vec2 ground_m, Sums& sums) {
  const auto height_m = height_at(grid, ground_m);
  if (!height_m) return;
  const ProfilePoint p = to_profile_frame(view, {ground_m.x, ground_m.y, *height_m});
  if (view.is_perspective() && p.v < 2 * view.near_m) return;
  const InFront front = RayWalk(grid, view).in_front(p);

  constexpr int samples = 300;
  const double begin = view.is_perspective() ? view.near_m : p.v - kDiameter_m;
  double sampled = -kInfinity;
  for (int i = 0; i < samples; ++i) {
    const double w = begin + (p.v - begin) * i / samples;
    const ProfilePoint place = on_ray(view, p, w);
    const auto y = surface_y(grid, view, place);
    // Along a void's border rounding decides whether the ray is over ground.
    if (y && *y > sampled && surface_y(grid, view, {place.u - 1e-9, w, 0}) &&
        surface_y(grid, view, {place.u + 1e-9, w, 0}))
      sampled = *y;
  }
  const double own = project(view, p).y;
  INFO("ground " << ground_m.x << ", " << ground_m.y << ": walk " << front.greatest_y << " at "
                 << front.at_depth_m << ", sampled " << sampled << ", own " << own);
  REQUIRE(front.rounding > 0);
  REQUIRE(front.rounding < 1e-9);
  REQUIRE(front.greatest_y_apart <= front.greatest_y);
  // `height_at` moves places within 1e-9 of a cell onto the line, where the exaggerated heights
  // differ by at most 2 * 20 m a cell; at depth near_m that is twice as much in Y.
  // `surface_y_beside` moves them by 1e-9 m, where Y changes by at most 2 * 120 a metre.
  const double slack = 5e-7;
  REQUIRE(std::max(front.greatest_y, own) >= sampled - slack);
  ++sums.asked;
  if (front.greatest_y == -kInfinity) {
    ++sums.bare;
    return;
  }
  REQUIRE(front.at_depth_m < p.v);
  REQUIRE(front.at_depth_m >= begin);
  REQUIRE(std::abs(surface_y_beside(grid, view, on_ray(view, p, front.at_depth_m)) -
                   front.greatest_y) <= slack);
  sums.hidden += front.greatest_y > own + slack ? 1 : 0;
}

// Views along the grid, along its diagonals and odd ones; eyes on vertices, on lines, and anywhere.
View random_view(Random& random, const Grid& grid) {
  const auto projection = random.chance(0.5) ? Projection::perspective : Projection::orthographic;
  const double azimuth = random.chance(0.6) ? 45.0 * random.whole(0, 7) : random.between(0, 360);
  Vec2 eye =
      grid.plane().position_m(random.whole(-3, grid.columns + 2), random.whole(-3, grid.rows + 2));
  if (random.chance(0.3)) eye = eye + Vec2{random.between(-1, 1), random.between(-1, 1)};
  View view = looking(projection, azimuth, random.pick({0.0, 10.0, 37.5, 80.0, 90.0}), eye,
                      random.between(-5, 40));
  view.exaggeration = random.pick({1.0, 2.0});
  if (!view.is_perspective() && random.chance(0.5)) { // oblique
    view.x_per_v = random.pick({-1.0, 0.5, random.between(-1.5, 1.5)});
    view.y_per_v = random.pick({0.0, 1.0, random.between(0, 1.5)});
    view.y_per_z = 1;
  }
  return view;
}

// Vertices, places on columns, rows and diagonals, and anywhere.
Vec2 random_place(Random& random, const Grid& grid) {
  const int c = random.whole(0, grid.columns - 1), r = random.whole(0, grid.rows - 1);
  const Vec2 at = grid.plane().position_m(c, r);
  const double s = random.share(), t = random.share();
  switch (random.whole(0, 4)) {
  case 0:
    return at;
  case 1:
    return at + t * grid.plane().row_step_m;
  case 2:
    return at + t * grid.plane().column_step_m;
  case 3:
    return at + t * (grid.plane().column_step_m + grid.plane().row_step_m);
  default:
    return at + s * grid.plane().column_step_m + t * grid.plane().row_step_m;
  }
}

Sums check_many(Random& random, const Grid& grid, int views, int places) {
  Sums sums;
  for (int i = 0; i < views; ++i) {
    const View view = random_view(random, grid);
    CAPTURE(i, view.is_perspective(), view.depth_origin_m.x, view.depth_origin_m.y, view.forward.x,
            view.forward.y, view.eye_z_m);
    for (int place = 0; place < places; ++place)
      check(grid, view, random_place(random, grid), sums);
  }
  return sums;
}

} // namespace

TEST_CASE("a wall across the view, reckoned by hand") {
  // From the north: ground, a wall 6 m high along the row at 2 m north, ground.
  const Grid grid = square_grid(3, {0, 0, 0, 0, 0, 0, 6, 6, 6, 0, 0, 0, 0, 0, 0});
  SECTION("parallel, level: Y is the height") {
    const RayWalk walk(grid, looking(Projection::orthographic, 0, 0, {0, 0}));
    for (const double u : {0.0, 0.3, 1.0, 2.0}) { // the border, a cell, a column, the border
      CAPTURE(u);
      const InFront behind = walk.in_front({u, 3.5, 0});
      CHECK(std::abs(behind.greatest_y - 6) <= behind.rounding);
      CHECK(std::abs(behind.at_depth_m - 2) <= 1e-12);
      // Strictly nearer: not the wall's own foot.
      const InFront before = walk.in_front({u, 0.5, 0});
      CHECK(std::abs(before.greatest_y) <= before.rounding);
      CHECK(walk.in_front({u, 0, 0}).greatest_y == -kInfinity);
    }
    CHECK(walk.in_front({-0.1, 3.5, 0}).greatest_y == -kInfinity);
    CHECK(walk.in_front({2.1, 3.5, 0}).greatest_y == -kInfinity);
  }
  SECTION("parallel, descending at 30 degrees: Y = z cos 30 + v sin 30") {
    const RayWalk walk(grid, looking(Projection::orthographic, 0, 30, {1, -5}));
    const InFront front = walk.in_front({0.25, 8, 0}); // 3 m north, 8 m from the origin
    CHECK(std::abs(front.greatest_y - (3 * std::sqrt(3) + 3.5)) <= 1e-14);
    CHECK(std::abs(front.at_depth_m - 7) <= 1e-14);
  }
  SECTION("perspective from 4 m before the wall and 3 m up: Y = (z - 3) / v") {
    const RayWalk walk(grid, looking(Projection::perspective, 0, 0, {1, -2}, 3));
    const InFront front = walk.in_front({0.5, 6, 0});
    CHECK(std::abs(front.greatest_y - 0.75) <= 1e-15);
    CHECK(std::abs(front.at_depth_m - 4) <= 1e-14);
    // Before the wall, the ground at the data's edge is the lowest; what is nearest to the point is
    // the highest: the row at 1 m north.
    const InFront before = walk.in_front({0, 3.5, 3});
    CHECK(std::abs(before.greatest_y - -1) <= 1e-15);
    CHECK(std::abs(before.at_depth_m - 3) <= 1e-14);
  }
}

TEST_CASE("in perspective the ground begins at the near plane") {
  // A slope that falls away from the eye, 10 m up at its south border; the eye stands on it.
  const Grid grid = heights_by({3, 12, {0, 11}, {1, 0}, {0, -1}},
                               [](int, int row) { return static_cast<double>(row); });
  const View view = looking(Projection::perspective, 0, 0, {0.7, 2.3}, 9);
  // At depth w the ground is 8.7 - w high, and Y is (-0.3 - w) / w, which grows with w. Of the
  // edges in front, the diagonal x + y = 11 is the nearest to the point: 3 + 1.0125 w = 11.
  const InFront front = RayWalk(grid, view).in_front({0.1, 8, 0.7});
  CHECK(std::abs(front.at_depth_m - 8 / 1.0125) <= 1e-13);
  CHECK(std::abs(front.greatest_y - (-1 - 0.3 / (8 / 1.0125))) <= 1e-14);
  // With the eye under the ground, it is greatest at the near plane.
  View buried = view;
  buried.eye_z_m = 8;
  const InFront under = RayWalk(grid, buried).in_front({0.1, 8, 0.7});
  CHECK(std::abs(under.greatest_y - (0.7 - kNear_m) / kNear_m) <= 1e-12);
  CHECK(under.at_depth_m == kNear_m);
}

TEST_CASE("rays along edges and through vertices meet what is there on either side") {
  // One triangle alone is there, on the west of the column at 1 m east: its vertices are (0, 2),
  // (1, 1) and (1, 2), heights 1, 2 and 3.
  const Grid grid = square_grid(3, {1, 3, kHole, kHole, 2, kHole, kHole, kHole, kHole});
  const auto at = [&](double azimuth, Vec2 origin, ProfilePoint p) {
    return RayWalk(grid, looking(Projection::orthographic, azimuth, 0, origin)).in_front(p);
  };
  SECTION("along its column edge, from the south and from the north") {
    CHECK(at(0, {1, 0}, {0, 5, 0}).greatest_y == 3);
    CHECK(at(180, {1, 5}, {0, 9, 0}).greatest_y == 3);
    CHECK(at(0, {1, 0}, {0, 1.5, 0}).greatest_y == 2); // halfway, strictly nearer is the south end
    CHECK(at(0, {1, 0}, {1e-6, 5, 0}).greatest_y == -kInfinity);
  }
  SECTION("along its row edge") {
    CHECK(at(90, {0, 2}, {0, 5, 0}).greatest_y == 3);
    CHECK(at(270, {1, 2}, {0, 5, 0}).greatest_y == 3);
    CHECK(at(90, {0, 2}, {-1e-6, 5, 0}).greatest_y == -kInfinity);
  }
  SECTION("along its diagonal") {
    CHECK(at(135, {0, 2}, {0, 5, 0}).greatest_y == 2);
    CHECK(at(315, {1, 1}, {0, 5, 0}).greatest_y == 2);
    CHECK(at(135, {0, 2}, {1e-6, 5, 0}).greatest_y == -kInfinity);
  }
  SECTION("through a vertex alone") {
    CHECK(std::abs(at(45, {0, 2}, {0, 5, 0}).greatest_y - 1) <= 1e-13);
    CHECK(at(90, {0, 1}, {0, 5, 0}).greatest_y == 2);
  }
}

TEST_CASE("a summit of 10 m behind 11 m of ground hides what is under the line of sight") {
  // A cone of height 10 and radius 10 around (12, 12); the eye at its height, 20 m from the summit.
  const Grid grid = heights_by({25, 25, {0, 24}, {1, 0}, {0, -1}}, [](int c, int r) {
    return std::max(0.0, 10 - std::hypot(c - 12.0, r - 12.0));
  });
  const RayWalk walk(grid, looking(Projection::perspective, 0, 0, {12, -8}, 5));
  // Along the axis the section is the cone's own: the summit is at Y = 5 / 20.
  const InFront front = walk.in_front({0, 32, 0});
  CHECK(std::abs(front.greatest_y - 0.25) <= 1e-15);
  CHECK(std::abs(front.at_depth_m - 20) <= 1e-13);
  // A point 4 m from the axis is behind the flank's highest edge there, not behind the summit.
  const InFront flank = walk.in_front({4, 32, 0});
  CHECK(flank.greatest_y < 0.25);
  CHECK(flank.greatest_y > 0.1);
}

TEST_CASE("against the surface sampled along the ray: random heights, holes, turned grids") {
  Sums sums;
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    CAPTURE(seed);
    Random random(seed);
    GridLattice lattice = turned_lattice(random.whole(2, 12), random.whole(2, 12),
                                         {random.pick({1.0, 2.0}), random.pick({1.0, 1.5})},
                                         seed % 3 == 0 ? random.between(-3, 3) : 0,
                                         seed % 6 == 0 ? random.between(-0.5, 0.5) : 0);
    const Grid grid = made_grid(
        random, lattice, {0, 10, seed % 2 ? 0.15 : 0, random.chance(0.5), random.chance(0.5)});
    const Sums some = check_many(random, grid, 20, 25);
    sums = {sums.asked + some.asked, sums.hidden + some.hidden, sums.bare + some.bare};
  }
  WARN(sums.asked << " asked, " << sums.hidden << " hidden, " << sums.bare
                  << " with nothing in front");
  CHECK(sums.hidden > sums.asked / 10);
  CHECK(sums.hidden + sums.bare < sums.asked / 10 * 9);
  CHECK(sums.asked > enough(10000));
}

TEST_CASE("against the surface sampled along the ray: cone, ridge, steps, with a hole") {
  const GridLattice lattice = turned_lattice(13, 13, {1, 1}, 0);
  const auto cone = [](int c, int r) { return std::max(0.0, 8 - std::hypot(c - 6, r - 6)); };
  const auto ridge = [](int c, int r) { return std::max(0.0, 5 - 2.0 * std::abs(c + r - 12)); };
  const auto steps = [](int c, int r) { return 2 * (c / 3) + r / 4; };
  const std::vector<std::function<double(int, int)>> shapes{cone, ridge, steps};
  Random random(7);
  for (const auto& shape : shapes)
    for (const bool hole : {false, true}) {
      const Grid grid = heights_by(lattice, [&](int c, int r) {
        return hole && std::abs(c - 4) < 2 && std::abs(r - 7) < 2 ? kHole : shape(c, r);
      });
      CHECK(check_many(random, grid, 40, 25).asked > 400);
    }
}

} // namespace orograph::ray_walk_test
