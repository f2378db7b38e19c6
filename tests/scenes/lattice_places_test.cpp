// SPDX-License-Identifier: GPL-3.0-or-later
// Where a profile of a lattice in degrees is taken: from the first to the last strip of cells that
// has ground at its depth.
#include "hidden_lines/lattice_in_work.hpp"
#include "tests/catch.hpp"
#include "tests/support/made_earth_grid.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <cstdint>
#include <optional>

namespace orograph::lattice_places_test {

TEST_CASE("a profile's places in degrees are all that hold its depth, and no more at the ends") {
  std::uint64_t asked = 0, narrow = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(60); ++seed) {
    Random random(seed);
    CAPTURE(seed);
    MadeEarth made;
    made.columns = random.whole(3, 40);
    made.rows = random.whole(3, 40);
    made.lon_step_deg = made.lat_step_deg = 1 / 1200.0;
    const Grid grid = made_earth_grid(random, made);
    const Vec2 forward = direction_of_azimuth(
        Angle::degrees(90.0 * random.whole(0, 3) + random.pick({0.0, random.between(-20, 20)})));
    const Vec3 middle = grid.earth().vertex_m(grid.columns / 2, grid.rows / 2, 0);
    View view;
    view.forward = forward;
    view.right = {forward.y, -forward.x};
    view.depth_origin_m = Vec2{middle.x, middle.y} - 20000 * forward;
    view.eye_z_m = middle.z + 3000;
    view.near_m = 1;
    const std::optional<EarthStrips> strips = EarthStrips::of(grid, view, {{-10, 10}, 1});
    if (!strips) continue;
    const SectorLattice lattice(grid, view, &*strips);
    const std::uint32_t count = lattice.order.place_count();
    for (int i = 0; i < 100; ++i) {
      const double depth_m = random.between(18000, 22000);
      // By its definition, place by place.
      std::optional<LatticeOrder::Places> expected;
      for (std::uint32_t place = 0; place < count; ++place) {
        const int strip = lattice.order.place(place).strip;
        if (strip == LatticeOrder::Place::kNone) continue;
        const auto [nearest_m, farthest_m] = strips->depths_of(strip);
        if (depth_m < nearest_m || depth_m > farthest_m) continue;
        if (!expected) expected = {place, place};
        expected->last = place;
      }
      const auto [first, last] = lattice.places_of(depth_m, {-1e5, 1e5});
      if (!expected) continue;
      ++asked;
      CAPTURE(depth_m, first, last, expected->first, expected->last, count);
      REQUIRE(first <= expected->first);
      REQUIRE(last >= expected->last);
      // Strips come outwards, so that hardly any more are beside them.
      narrow += last - first <= expected->last - expected->first + 1 ? 1 : 0;
    }
  }
  CAPTURE(asked, narrow);
  CHECK(asked > enough(1000));
  CHECK(10 * narrow > 9 * asked);
}

} // namespace orograph::lattice_places_test
