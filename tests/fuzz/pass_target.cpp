// SPDX-License-Identifier: GPL-3.0-or-later
// A lattice of a few vertices and a view of it from bytes, asked of sight through every triangle.
#include "geometry/on_all_cores.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/stability/judged_view.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace orograph {
namespace {

Grid grid_of(Bytes& bytes) {
  Grid grid;
  grid.columns = bytes.whole(2, 6);
  grid.rows = bytes.whole(2, 6);
  const double cell_m = std::ldexp(1, bytes.whole(-10, 10));
  grid.lattice = PlaneLattice{{0, 0}, {cell_m, 0}, {0, -cell_m * bytes.whole(1, 3)}};
  const bool has_voids = bytes.whole(0, 3) == 0;
  std::vector<double> heights(grid.size());
  for (double& height : heights) {
    const bool is_void = has_voids && bytes.whole(0, 4) == 0;
    height = is_void ? std::numeric_limits<double>::quiet_NaN()
                     : cell_m * std::clamp(bytes.number(), -1e9, 1e9);
  }
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}, grid.index(1, 1)})
    if (std::isnan(heights[i])) heights[i] = 0;
  grid.heights_m = Heights<double>(std::move(heights));
  return grid;
}

} // namespace

void fuzz_pass(FuzzBytes all) {
  Bytes bytes(all);
  TerrainData terrain;
  const Grid grid = grid_of(bytes);
  const double cell_m = grid.plane().column_step_m.x;
  terrain.surface = grid;
  MapSpec spec;
  ViewSpec& view = spec.view;
  view.exaggeration = 1;
  view.from_azimuth =
      Angle::degrees(bytes.whole(0, 1) ? 45.0 * bytes.whole(0, 7) : 360.0 * bytes.next() / 256);
  view.from_elevation = Angle::degrees(std::clamp(std::abs(10 * bytes.number()), 0.0, 90.0));
  switch (bytes.whole(0, 3)) {
  case 0:
    view.projection = Projection::orthographic;
    break;
  case 1:
    view.projection = Projection::oblique;
    view.from_elevation = Angle::degrees(30);
    break;
  case 2:
    view.from_elevation = Angle::degrees(0.5 * view.from_elevation.in_degrees());
    break;
  default: {
    const Vec2 at =
        grid.plane().position_m(bytes.whole(0, grid.columns - 1), bytes.whole(0, grid.rows - 1));
    const Vec2 to =
        grid.plane().position_m(bytes.whole(0, grid.columns - 1), bytes.whole(0, grid.rows - 1));
    const double height = grid.height_m(0, 0) + cell_m * bytes.number();
    view.eye_map = Vec3{at.x + cell_m * bytes.next() / 256, at.y, height};
    view.look_at_map = Vec3{to.x, to.y, height - cell_m * bytes.whole(0, 3)};
    view.field_of_view = Angle::degrees(bytes.whole(10, 160));
  }
  }
  spec.style.plan = bytes.whole(0, 1) ? PlanRequest(ProfileCount{bytes.whole(1, 6)})
                                      : PlanRequest(GroundSpacing{cell_m});
  const std::uint64_t seed = bytes.next();
  const bool as_tin = bytes.whole(0, 3) == 0;
  Judged judged;
  // In one thread: more take longer for so little, and make the places reached change from run to
  // run.
  on_cores(1, {}, [&] { judged = judge_view(std::move(terrain), spec, 30, seed, as_tin); });
  expect(judged.wrong == 0, judged.first_wrong);
}

} // namespace orograph
