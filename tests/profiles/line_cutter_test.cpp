// SPDX-License-Identifier: GPL-3.0-or-later
// The quick cut against the walk from triangle to triangle.
#include "profiles/line_cutter.hpp"
#include "profiles/walk_grid.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_grid.hpp"
#include "tests/support/random.hpp"

#include <cmath>

namespace orograph::line_cutter_test {
namespace {

GridLattice upright_lattice(Random& random, int most) {
  GridLattice lattice{random.whole(2, most), random.whole(2, most), {}, {}, {}};
  const bool whole = random.chance(0.5);
  const auto step = [&] { return whole ? random.whole(1, 3) : random.between(0.5, 30); };
  lattice.column_step_m = {step(), 0};
  lattice.row_step_m = {0, -step()};
  if (random.chance(0.1)) { // turned about
    lattice.column_step_m.x *= -1;
    lattice.row_step_m.y *= -1;
  }
  const double offset = random.pick({0.0, 0.0, 100.0, 1e7});
  lattice.first_vertex_m = whole ? Vec2{1.0 * random.whole(-9, 9), 1.0 * random.whole(-9, 9)}
                                 : offset * Vec2{random.between(-1, 1), random.between(-1, 1)};
  return lattice;
}

TriangleSet some_level(Random& random, const Grid& grid) {
  TriangleSet level(grid_triangle_count(grid));
  for (std::size_t t = 0; t < grid_triangle_count(grid); ++t)
    if (random.chance(0.3)) level.add(t);
  return level;
}

// The same number; a zero may have another sign.
bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

// Where in `whole` the part's vertices stand, one after another; its size if they don't.
std::size_t place_of(const Profile& part, const Profile& whole) {
  for (std::size_t at = 0; at + part.size() <= whole.size(); ++at) {
    std::size_t count = 0;
    while (count < part.size() && same(part.u_m[count], whole.u_m[at + count]) &&
           same(part.z_m[count], whole.z_m[at + count]))
      ++count;
    if (count == part.size()) return at;
  }
  return whole.size();
}

struct Tally {
  std::size_t quick = 0, asked = 0, parts = 0, rows = 0;
};

void check_planes(Random& random, const Grid& grid, View view, Tally& tally) {
  if (random.chance(0.3)) view.drop = {1e-7, 2e-8, 3e-7};
  const TriangleSet level = random.chance(0.3) ? some_level(random, grid) : TriangleSet();
  // Along rows or columns depth rises from each to the next in floating point, too: so much do
  // these grids' steps exceed rounding.
  const bool along = !row_depths(grid, view).empty();
  const LineCutter cutter(grid, view, level, along ? 0 : 1e-6);
  double nearest = HUGE_VAL, farthest = -HUGE_VAL;
  for (const int c : {0, grid.columns - 1})
    for (const int r : {0, grid.rows - 1}) {
      const double v = to_profile_frame(view, grid.vertex_m(c, r)).v;
      nearest = std::min(nearest, v);
      farthest = std::max(farthest, v);
    }
  Profile quick, walked, part;
  for (int i = 0; i < 8; ++i) {
    const double vertex = to_profile_frame(view, grid.vertex_m(random.whole(0, grid.columns - 1),
                                                               random.whole(0, grid.rows - 1)))
                              .v;
    const bool at_vertex = random.chance(0.3);
    const double depth = at_vertex ? vertex : random.between(nearest, farthest);
    const GridPlane plane{depth, depth > nearest};
    ++tally.asked;
    quick.clear();
    if (!cutter.cut(plane, {}, quick)) continue;
    ++tally.quick;
    if (along && at_vertex) ++tally.rows;
    walked.clear();
    walk_grid(grid, view, level, plane, true, walked);
    CAPTURE(depth, grid.columns, grid.rows, view.forward.x, view.forward.y);
    REQUIRE(quick.size() == walked.size());
    REQUIRE(place_of(quick, walked) == 0);
    REQUIRE(quick.after == walked.after);
    if (quick.size() == 0) continue;

    URange range{random.between(quick.u_m.front() - 5, quick.u_m.back() + 5), 0};
    range.high_m = range.low_m + random.pick({0.0, 1.0, 30.0, 1000.0});
    part.clear();
    REQUIRE(cutter.cut(plane, range, part));
    const std::size_t at = place_of(part, quick);
    REQUIRE((part.size() == 0 || at < quick.size()));
    tally.parts += part.size() > 0 && part.size() < quick.size() ? 1 : 0;
    for (std::size_t m = 0; m < quick.size(); ++m) {
      const bool beside = quick.u_m[m] >= range.low_m && quick.u_m[m] <= range.high_m;
      const bool before =
          m + 1 < quick.size() && quick.u_m[m + 1] >= range.low_m && quick.u_m[m] <= range.high_m;
      const bool behind = m > 0 && quick.u_m[m - 1] <= range.high_m && quick.u_m[m] >= range.low_m;
      if (beside || before || behind) REQUIRE((m >= at && m < at + part.size()));
    }
    for (std::size_t m = 0; m + 1 < part.size(); ++m) REQUIRE(part.after[m] == quick.after[at + m]);
    if (part.size() > 0) REQUIRE(part.after.back() == Span::gap);
  }
}

} // namespace

TEST_CASE("the quick cut is that of the walk, whole and in parts") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= last_seed(6000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    GridHeights heights;
    heights.missing = random.pick({0.0, 0.0, 0.05, 0.3});
    heights.in_double = random.chance(0.5);
    const int most = random.pick({3, 9, 40, 400});
    const Grid grid = made_grid(random, upright_lattice(random, most), heights);
    const double azimuth = random.chance(0.3) ? 45.0 * random.whole(0, 7) : random.between(0, 360);
    check_planes(random, grid, looking(direction_of_azimuth(Angle::degrees(azimuth)), {3, 4}, 1.5),
                 tally);
  }
  WARN(tally.quick << " planes of " << tally.asked << " cut quickly, " << tally.rows
                   << " of them in rows; " << tally.parts << " parts");
  CHECK(tally.quick > tally.asked * 6 / 10);
  CHECK(tally.rows > tally.asked / 40);
}

} // namespace orograph::line_cutter_test
