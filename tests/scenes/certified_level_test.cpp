// SPDX-License-Identifier: GPL-3.0-or-later
// Larger cells within a bound on the page: no point of the ground is off by more, and the file's
// own surface hides nothing that is drawn by more than twice that.
#include "dem/height_at.hpp"
#include "dem/levels/nested_in_bands.hpp"
#include "dem/levels/patchwork.hpp"
#include "dem/levels/raster_patches.hpp"
#include "map/draw_level.hpp"
#include "placing/certified_raster.hpp"
#include "placing/level_of_detail.hpp"
#include "placing/patches_of_raster.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/raster_in_parts.hpp"
#include "tests/support/earth_terrain.hpp"
#include "tests/support/plane_terrain.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <variant>

namespace orograph::certified_level_test {
namespace {

// Hills, rough in one corner, and a void.
double height_m(double x, double y) {
  if (std::hypot(x - 2.2, y - 2.2) < 0.1) return std::numeric_limits<double>::quiet_NaN();
  const double rough = x + y < 0.6 ? 12 * std::sin(90 * x) * std::sin(101 * y) : 0;
  return 400 * std::sin(x * 0.5) * std::cos(y * 0.4) + 30 * std::sin(x + 0.7 * y) + rough;
}

TerrainData made_terrain(Random& random, bool on_earth) {
  // Sizes that 16 cells of a level part evenly, and others.
  const int columns = random.pick({513, 577, 536}), rows = random.pick({513, 545, 537});
  if (on_earth)
    return earth_terrain({8, 0.0005, columns, 46, -0.0004, rows}, [](double lon, double lat) {
      return height_m(40 * (lon - 8), 50 * (46 - lat));
    });
  return plane_terrain(columns, rows, height_m);
}

void look_somehow(ViewSpec& view, Random& random, bool on_earth) {
  switch (random.whole(0, 3)) {
  case 0:
    view.projection = Projection::orthographic;
    [[fallthrough]];
  case 1:
    view.from_azimuth = Angle::degrees(random.between(0, 360));
    view.from_elevation = Angle::degrees(random.between(3, 89));
    break;
  case 2:
    view.projection = Projection::cylindrical;
    [[fallthrough]];
  default:
    if (on_earth)
      view.eye_lonlat = GivenPlace{random.between(8.01, 8.045), random.between(45.965, 45.99)};
    else
      view.eye_map = GivenPlace{random.between(500, 2700), random.between(-5000, -500)};
    view.eye_height_m = random.pick({2.0, 100.0, 900.0});
    view.look_azimuth = Angle::degrees(random.between(0, 360));
  }
}

// How far places of the file's surface are on the page from those of the drawn one straight above
// or below them, at most.
double greatest_mm(const Grid& file, const Surface& drawn, const PlacedView& placed,
                   Random& random) {
  double greatest = 0;
  const auto on_page = [&](Vec3 at) { return placed.on_page(to_profile_frame(placed.view, at)); };
  for (int i = 0; i < 400; ++i) {
    const int column = random.whole(0, file.columns - 1), row = random.whole(0, file.rows - 1);
    if (std::isnan(file.height_m(column, row))) continue;
    const Vec3 vertex = file.vertex_m(column, row);
    const auto height = height_at(drawn, {vertex.x, vertex.y});
    if (!height) continue;
    const Vec3 from = on_page(vertex), to = on_page({vertex.x, vertex.y, *height});
    if (!(from.z > 0 && to.z > 0)) continue;
    const Vec2 at{from.x / from.z, from.y / from.z};
    const Box2& frame = placed.frame_mm;
    if (at.x < frame.low.x || at.x > frame.high.x || at.y < frame.low.y || at.y > frame.high.y)
      continue;
    greatest = std::max(greatest, std::hypot(at.x - to.x / to.z, at.y - to.y / to.z));
  }
  return greatest;
}

NestedCells nested_cells(const Grid& grid) {
  return std::visit(
      [&]<class Height>(const Heights<Height>& heights) {
        NestedInBands<Height> nested(grid.columns, grid.rows);
        nested.take({0, grid.rows,
                     std::make_shared<const std::vector<Height>>(heights.data(),
                                                                 heights.data() + grid.size())});
        return nested.move_cells();
      },
      grid.heights_m);
}

// As a large raster is read: in larger cells, with nested ones.
TerrainData in_larger_and_nested_cells(const TerrainData& file, int step) {
  TerrainData out = in_larger_cells(file, step);
  out.larger_cells->nested =
      std::make_shared<const NestedCells>(nested_cells(std::get<Grid>(file.surface)));
  return out;
}

bool are_same(const Patchwork& a, const Patchwork& b) {
  return a.places == b.places && a.heights_m == b.heights_m && a.tin.triangles == b.tin.triangles;
}

} // namespace

TEST_CASE("no point of a certified level is off by more than is told, or asked for",
          "[unsanitized]") {
  std::size_t levels = 0, ties = 0, tight = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(24); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const bool on_earth = random.chance(0.4);
    const TerrainData whole = made_terrain(random, on_earth);
    MapSpec spec;
    spec.style.detail.error_mm = random.pick({0.1, 0.3, 0.8});
    spec.style.light.reset();
    spec.view.exaggeration = random.pick({1.0, 3.0});
    look_somehow(spec.view, random, on_earth);
    spec.check = spec.check_of_file = 1500;
    TerrainOfView terrain(whole, spec.view);
    const auto level = choose_level(terrain, spec, nullptr);
    if (!level) continue;
    ++levels;
    CHECK(level->most_step >= level->step); // larger cells may all be behind the eye
    CHECK(level->greatest_mm <= *spec.style.detail.error_mm);
    const PlacedView placed = placed_view(terrain, spec);
    const double measured =
        greatest_mm(std::get<Grid>(terrain.of_file().surface), terrain->surface, placed, random);
    CHECK(measured <= level->greatest_mm);
    tight += measured > 0.2 * level->greatest_mm;
    const Map map = draw_level(terrain, placed, spec, level, [](double) {});
    REQUIRE(map.facts.check);
    CHECK(map.facts.check->hidden + map.facts.check->missing == 0);
    REQUIRE(map.facts.check_of_file);
    CHECK(map.facts.check_of_file->within_mm == level->greatest_mm);
    CHECK(map.facts.check_of_file->counts.asked > 100);
    CHECK(map.facts.check_of_file->counts.hidden == 0);
    ties += map.facts.check_of_file->counts.ties;
  }
  CHECK(levels > enough(10));
  CHECK(tight > enough(6));  // or the bound would be no measure
  CHECK(ties > enough(300)); // which the file's surface hides by less
}

TEST_CASE("a raster that isn't in memory has the certified patches that it has in memory") {
  std::size_t several = 0, patches_of_levels = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(10); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const bool on_earth = random.chance(0.4);
    const TerrainData file = made_terrain(random, on_earth);
    MapSpec spec;
    spec.style.detail.error_mm = random.pick({0.3, 0.8, 2.0});
    spec.style.light.reset();
    look_somehow(spec.view, random, on_earth);
    TerrainData whole = in_larger_and_nested_cells(file, random.pick({2, 4}));
    add_parts(whole, std::get<Grid>(file.surface), spec,
              [&](const TerrainData& framed, const PlacedView& on) {
                return CertifiedRaster(framed, on, spec).missing();
              });

    // In the same picture: the same patches, and the same surface, to the bit.
    const TerrainOfView of_file(file, spec.view), of_larger(whole, spec.view);
    const PlacedView placed = placed_picture(*of_larger, facts_of(*of_larger), spec, nullptr);
    const CertifiedRaster certified(*of_larger, placed, spec);
    const Grid& grid = std::get<Grid>(of_file->surface);
    PlacedView raised = placed;
    if (spec.view.has_eye())
      raised.view.eye_z_m +=
          placed.view.exaggeration *
          rise_of_raster(*of_larger, certified.raster(), placed.view.depth_origin_m);
    const HeightOnPage heights(grid, raised);
    const Patches patches =
        certified_patches(grid, heights, kFramedAnew * *spec.style.detail.error_mm);
    REQUIRE(patches.patches() == certified.patches().patches());
    const Patchwork made = patchwork(grid, patches, patches_of_grid(grid, patches, {}));
    const Patchwork from_nested = patchwork(std::get<Grid>(of_larger->surface), patches,
                                            nested_patches(*of_larger->larger_cells));
    CHECK(are_same(made, from_nested));
    for (std::size_t i = 0; i < made.departures.size(); ++i) {
      // Which look at a patch's far borders as well.
      CHECK(from_nested.departures[i].greatest_m > made.departures[i].greatest_m - 1e-9);
      CHECK(std::abs(made.departures[i].rms_m - from_nested.departures[i].rms_m) < 1e-9);
    }
    for (const Patch& patch : patches.patches()) patches_of_levels += patch.level >= kFinestKept;

    // And what is drawn of it is within the bound, from the file's own surface.
    TerrainOfView terrain(whole, spec.view);
    const auto level = choose_level(terrain, spec, nullptr);
    REQUIRE(level);
    several += level->most_step > level->step;
    CHECK(level->greatest_mm <= *spec.style.detail.error_mm);
    CHECK(greatest_mm(grid, terrain->surface, placed_view(terrain, spec), random) <=
          level->greatest_mm);
  }
  CHECK(several > enough(5));
  CHECK(patches_of_levels > enough(100));
}

} // namespace orograph::certified_level_test
