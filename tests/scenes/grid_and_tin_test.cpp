// SPDX-License-Identifier: GPL-3.0-or-later
// One surface, as a grid and as the TIN of its triangles: the same lines, and the same of them is
// visible, but for declared ties.
#include "dem/approximate/tin_of_grid.hpp"
#include "dem/read/read_raster.hpp"
#include "map/draw_map.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/visible_parts.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"
#include "tests/support/sample_names.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace orograph::grid_and_tin_test {
namespace {

// The smallest region of a grid that counts as water, as an area.
double smallest_water_m2(const Grid& grid) {
  const double triangles =
      static_cast<double>(std::max<std::size_t>(500, 2 * grid.size() / 5000)) - 0.5;
  return triangles * std::abs(cross(grid.plane().column_step_m, grid.plane().row_step_m)) / 2;
}

struct Compared {
  std::size_t lines = 0, tied = 0, views = 0;
};

// To the bit.
bool same(const ProfileLine& a, const ProfileLine& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

void compare_in(const TerrainData& as_grid, const TerrainData& as_tin, const MapSpec& spec,
                Compared& compared) {
  const Grid& grid = grid_of(as_grid);
  const Tin& tin = std::get<Tin>(as_tin.surface);
  const PlacedView by_grid = placed_view(as_grid, spec);
  // The same view and plan; what belongs to the surface is the TIN's own.
  PlacedView by_tin = by_grid;
  by_tin.border = border_edges(tin);
  by_tin.level = find_level_ground(tin, smallest_water_m2(grid));
  VisibleParts of_grid(by_grid), of_tin(by_tin);
  draw_map(as_grid, by_grid, spec, [](double) {},
           {.observers = {&of_grid}, .beyond_page = true, .order_always = true});
  draw_map(as_tin, by_tin, spec, [](double) {}, {.observers = {&of_tin}, .beyond_page = true});
  REQUIRE(of_grid.lines.size() == of_tin.lines.size());
  std::size_t others = 0;
  for (std::size_t i = 0; i < of_grid.lines.size(); ++i)
    others += same(of_grid.lines[i].whole, of_tin.lines[i].whole) ? 0 : 1;
  CHECK(others == 0);
  const VisibleDifference found =
      difference(of_grid, of_tin, by_grid,
                 judges_of(as_grid.surface, by_grid, spec.style.visibility_tolerance_mm));
  INFO(found.first_wrong);
  CHECK(found.wrong() == 0);
  compared.lines += of_grid.lines.size();
  compared.tied += found.tied;
  ++compared.views;
}

void report(const Compared& compared) {
  WARN(compared.views << " views, " << compared.lines << " lines; " << compared.tied
                      << " stretches differ and are tied");
  CHECK(compared.tied <= compared.lines / 10000);
}

TerrainData tin_terrain(const TerrainData& as_grid) {
  TerrainData terrain = as_grid;
  terrain.surface = tin_of(grid_of(as_grid));
  return terrain;
}

} // namespace

TEST_CASE("all samples, six views each", "[slow]") {
  const int kViews = last_seed(6);
  Compared compared;
  for (const char* name : sample_names()) {
    const TerrainData as_grid =
        read_raster(std::string(OROGRAPH_SOURCE_DIR "/data_samples/") + name + ".tif");
    const TerrainData as_tin = tin_terrain(as_grid);
    for (int i = 0; i < kViews; ++i) {
      MapSpec spec;
      spec.view.from_azimuth = Angle::degrees(i % 5 == 0 ? 45.0 * i : 37.3 * i);
      spec.view.from_elevation = Angle::degrees(i % 2 ? 8 + 3 * i : 40 - 3 * i);
      spec.view.projection = i % 3 == 2 ? Projection::orthographic : Projection::perspective;
      spec.style.plan = ProfileCount{40};
      if (i == 3) spec.style.occluder = Occluder::profiles;
      if (i == 4) spec.style.flat = FlatGround::draw;
      if (i == 6) spec.style.layers.push_back("edges");
      CAPTURE(name, i);
      compare_in(as_grid, as_tin, spec, compared);
    }
  }
  report(compared);
  CHECK(compared.views == kViews * sample_names().size());
  CHECK(compared.lines > enough(500000));
}

TEST_CASE("and made scenes with holes, spikes and steps") {
  Compared compared;
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    RandomScene scene = random_scene(seed);
    if (seed % 2 == 0) scene.spec.style.layers.push_back("voids");
    CAPTURE(seed, scene.what);
    compare_in(scene.terrain, tin_terrain(scene.terrain), scene.spec, compared);
  }
  report(compared);
  CHECK(compared.lines > enough(100000));
}

} // namespace orograph::grid_and_tin_test
