// SPDX-License-Identifier: GPL-3.0-or-later
// The order of a sheet's triangles: of a lattice in degrees seen along its rows and columns, where
// rounding, leaning and voids turn the edges within a strip of cells this way and that.
#include "profiles/sheet_order.hpp"
#include "tests/catch.hpp"
#include "tests/profiles/triangle_cuts.hpp"
#include "tests/support/made_earth_grid.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace orograph::sheet_order_test {
namespace {

// Cells of some 90 m, so steep and so far from the frame's origin that vertices lean by up to a
// third of a cell.
Grid steep_grid(Random& random) {
  MadeEarth made;
  made.columns = random.whole(3, 24);
  made.rows = random.whole(3, 24);
  made.lon_step_deg = made.lat_step_deg = 1.0 / 1200;
  made.west_deg += random.between(-0.5, 0.5);
  made.north_deg += random.between(-0.3, 0.3);
  return made_earth_grid(random, made);
}

// Across the grid's middle, from beside it.
View along_a_line(Random& random, const Grid& grid) {
  const double azimuth_deg = random.pick({0.0, 90.0, 180.0, 270.0}) + random.between(-3, 3);
  const Vec2 forward = direction_of_azimuth(Angle::degrees(azimuth_deg));
  const Vec3 middle = grid.earth().vertex_m(grid.columns / 2, grid.rows / 2, 0);
  const double away_m = random.between(2000, 20000);
  View view = looking(forward, {middle.x - away_m * forward.x, middle.y - away_m * forward.y});
  if (random.chance(0.2)) return view;
  view.projection = Projection::perspective;
  view.eye_z_m = middle.z + random.between(-1000, 6000);
  return view;
}

struct Passed {
  double from_m, to_m; ///< depths
  std::uint64_t place;
};

// What of a triangle's sides a ray at X crosses.
std::optional<Passed> passed(const std::array<ProfilePoint, 3>& corners, const View& view,
                             double x) {
  std::vector<double> depths;
  const auto aside = [&](ProfilePoint p) {
    return view.is_perspective() ? p.u - x * p.v : p.u + p.v * view.x_per_v - x;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const ProfilePoint a = corners[k], b = corners[(k + 1) % 3];
    const double of_a = aside(a), of_b = aside(b);
    if ((of_a < 0) != (of_b < 0)) depths.push_back(a.v + of_a / (of_a - of_b) * (b.v - a.v));
  }
  if (depths.empty()) return std::nullopt;
  const auto [low, high] = std::ranges::minmax(depths);
  return Passed{low, high, 0};
}

TEST_CASE("strips of cells in degrees are in order along every ray") {
  std::uint64_t asked = 0, sorted = 0, restless = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const Surface surface = steep_grid(random);
    const Grid& grid = std::get<Grid>(surface);
    if (leaning_triangles(grid) > 0) continue;
    const View view = along_a_line(random, grid);
    const SheetTriangles triangles(surface);
    const SheetPart all(triangles);
    const SheetVertices at(surface, view);
    constexpr double kFrom_m = 1;
    const auto strips = StripsOfCells::of(grid, at, all, view, kFrom_m);
    if (!strips) {
      ++sorted;
      continue;
    }
    for (int strip = 0; strip < strips->falling.strips(); ++strip)
      if (strips->falling.of_strip(strip).size() > 1) ++restless;
    const std::vector<BorderEdge> border = border_edges(grid, false);
    const SheetOrder order(surface, triangles, all, border, view, kFrom_m);
    for (int ray = 0; ray < 40; ++ray) {
      const auto of =
          static_cast<std::uint32_t>(random.whole(0, static_cast<int>(grid.size()) - 1));
      if (std::isnan(at[of].z)) continue;
      const double x = project(view, at[of]).x + random.between(-1e-3, 1e-3);
      std::vector<Passed> way;
      for (std::uint32_t t = 0; t < triangles.count(); ++t) {
        if (!triangles.is_there(t)) continue;
        const auto [a, b, c] = triangles.corners(t);
        auto of_triangle = passed({at[a], at[b], at[c]}, view, x);
        constexpr double kTouching_m = 1e-6;
        if (!of_triangle || of_triangle->to_m - of_triangle->from_m < kTouching_m) continue;
        of_triangle->place = order.place(t);
        way.push_back(*of_triangle);
      }
      std::ranges::sort(way, {}, &Passed::from_m);
      asked += way.size();
      CHECK(std::ranges::is_sorted(way, {}, &Passed::place));
    }
  }
  CAPTURE(asked, sorted, restless);
  CHECK(asked > 50'000);
  CHECK(restless > 100);
}

} // namespace
} // namespace orograph::sheet_order_test
