// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts of a grid on the ellipsoid of which one knows what comes out.
#include "dem/extent.hpp"
#include "profiles/cut_earth_grid.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_earth_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace orograph::cut_earth_grid_cases_test {
namespace {

std::shared_ptr<const BorderPlaces> places_of(const Grid& grid) {
  return std::make_shared<const BorderPlaces>(border_places(grid, border_edges(grid, false)));
}

} // namespace

// Round the top of a spike that leans beyond upright a plane goes without end.
TEST_CASE("a part that begins on a spike that leans over ends") {
  MadeEarth made;
  made.columns = made.rows = 20;
  made.lon_step_deg = made.lat_step_deg = 1;
  made.west_deg = made.origin_lon_deg = 0;
  made.north_deg = made.origin_lat_deg = 10;
  made.ellipsoid = {2e4, 0.0};
  std::vector<float> heights(400, 0);
  heights[10 * 20 + 15] = 5000;
  const Grid grid{20, 20, earth_lattice(made), std::move(heights)};
  REQUIRE(leaning_triangles(grid) > 0);
  const TriangleSet no_level;
  const Box3 box = extent_of(grid).box;
  std::size_t longest = 0;
  for (const Vec2 forward : {Vec2{0, 1}, Vec2{1, 0}, Vec2{-1, 0}}) {
    const View view = looking(forward);
    const EarthGridCutter cutter(grid, view, no_level, places_of(grid), &box);
    const Vec3 top = grid.vertex_m(15, 10);
    const ProfilePoint about = to_profile_frame(view, top);
    Profile profile;
    for (int i = -20; i <= 20; ++i)
      for (int k = -20; k <= 20; ++k) {
        const URange part{about.u + 100 * k, about.u + 1e5};
        cutter.cut(about.v + 100 * i, std::span(&part, 1), profile);
        longest = std::max(longest, profile.size());
      }
  }
  CHECK(longest > 20);
  CHECK(longest < 6 * grid.size());
}

TEST_CASE("a meridian and the equator lie in planes of one depth, and are there once") {
  MadeEarth made;
  made.columns = made.rows = 9;
  made.west_deg = 179.96;
  made.lon_step_deg = made.lat_step_deg = 0.01;
  made.north_deg = 0.04;
  made.origin_lon_deg = -180;
  made.origin_lat_deg = 0;
  Random random(1);
  Grid grid = made_grid(random, {9, 9}, {0, 500, 0, true, true});
  grid.lattice = earth_lattice(made);
  const TriangleSet no_level;
  for (const bool along_equator : {false, true}) {
    const View view = looking(along_equator ? Vec2{0, 1} : Vec2{1, 0});
    Profile profile;
    EarthGridCutter(grid, view, no_level, places_of(grid)).cut(0, profile);
    CAPTURE(along_equator);
    REQUIRE(profile.size() == 9);
    for (int i = 0; i < 9; ++i) {
      // From left to right: eastwards, or southwards.
      const Vec3 vertex = along_equator ? grid.vertex_m(i, 4) : grid.vertex_m(4, i);
      const auto k = static_cast<std::size_t>(i);
      CHECK(profile.u_m[k] == (along_equator ? vertex.x : -vertex.y));
      CHECK(profile.z_m[k] == vertex.z);
      CHECK((profile.after[k] == Span::slope) == (i < 8));
    }
  }
}

} // namespace orograph::cut_earth_grid_cases_test
