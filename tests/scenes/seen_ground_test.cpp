// SPDX-License-Identifier: GPL-3.0-or-later
// Ground that isn't looked at: none of it is to be seen, as the ray walk has it, and drawings are
// the same as with all ground looked at, to the bit.
#include "geometry/error.hpp"
#include "hidden_lines/sector_ground.hpp"
#include "hidden_lines/strips.hpp"
#include "map/draw_map.hpp"
#include "placing/terrain_of_view.hpp"
#include "reference/ray_walk.hpp"
#include "tests/catch.hpp"
#include "tests/scenes/put_eye.hpp"
#include "tests/scenes/random_earth_scene.hpp"
#include "tests/scenes/random_scene.hpp"
#include "tests/scenes/same_drawing.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph::seen_ground_test {
namespace {

const std::uint64_t kScenes = last_seed(200);
constexpr int kPoints = 400;
const Instruments kAlways{.ground_always = true};

struct Tally {
  std::size_t scenes = 0, asked = 0, beside = 0, refused = 0;
  double left_out = 0;
};

void add_spikes(TerrainData& terrain, Random& random, std::string& what) {
  const auto heights = std::get<Heights<float>>(grid_of(terrain).heights_m).own();
  const double high = random.pick({5.0, 50.0, 2000.0});
  for (float& h : heights)
    if (random.chance(0.02)) h += static_cast<float>(random.between(0, high));
  what += ", spikes";
}

RandomScene large_scene(std::uint64_t seed, Random& random) {
  RandomScene scene = random_scene(seed, random.pick({36, 100, 200}));
  Grid& grid = grid_of(scene.terrain);
  if (random.chance(0.3)) add_spikes(scene.terrain, random, scene.what);
  if (random.chance(0.3)) {
    const double radius = random.pick({2e4, 1e5, 1e6});
    scene.terrain.map.radii = CurvatureRadii{radius, radius * random.between(1, 1.3)};
    scene.spec.view.curvature = Curvature::on;
    scene.spec.view.refraction = random.pick({0.0, 0.13, 1.5});
    scene.what += ", curved";
  }
  MapSpec& spec = scene.spec;
  spec.view.from_elevation = Angle::degrees(random.pick({0.0, 2.0, 5.0, 10.0, 20.0, 45.0}));
  spec.style.visibility_tolerance_mm = random.pick({0.0, 0.0, 0.01, 0.5});
  if (random.chance(0.5)) {
    put_eye(spec, grid, random);
    spec.view.field_of_view = Angle::degrees(random.pick({3.0, 30.0, 90.0, 150.0}));
    scene.what += ", eye";
  }
  spec.style.layers = {"profiles", "silhouettes", "skyline", "border", "shores"};
  spec.style.simplify_mm = 0;
  spec.style.layers.push_back("voids");
  return scene;
}

// In degrees; from eyes on the ground all round as well.
RandomScene large_earth_scene(std::uint64_t seed, Random& random) {
  const Stand stand = random.pick({Stand::on_ground, Stand::on_ground, Stand::in_air,
                                   Stand::frames_terrain, Stand::looking_down});
  RandomScene scene = random_earth_scene(seed, stand, random.pick({36, 100, 160}));
  if (random.chance(0.3)) add_spikes(scene.terrain, random, scene.what);
  MapSpec& spec = scene.spec;
  if (stand == Stand::frames_terrain)
    spec.view.from_elevation = Angle::degrees(random.pick({0.0, 2.0, 5.0, 10.0, 20.0, 45.0}));
  if (stand == Stand::on_ground && random.chance(0.4)) {
    ViewSpec about;
    about.projection = random.pick({Projection::cylindrical, Projection::equirectangular});
    about.eye_map = spec.view.eye_map;
    about.eye_height_m = random.pick({0.5, 20.0, 200.0});
    about.exaggeration = spec.view.exaggeration;
    about.refraction = spec.view.refraction;
    spec.view = about;
    scene.what += ", panorama";
  }
  spec.style.visibility_tolerance_mm = random.pick({0.0, 0.0, 0.01, 0.5});
  spec.style.layers = {"profiles", "silhouettes", "skyline", "border", "shores", "voids"};
  spec.style.simplify_mm = 0;
  return scene;
}

// A point of the surface in a block: a vertex, or anywhere on a triangle.
std::optional<ProfilePoint> point_in(const Grid& grid, int column, int row, const View& view,
                                     Random& random) {
  const int side = SeenGround::kSide;
  const int c = std::min(column * side + random.whole(0, side - 1), grid.columns - 2),
            r = std::min(row * side + random.whole(0, side - 1), grid.rows - 2);
  const bool upper = random.chance(0.5), at_vertex = random.chance(0.5);
  double a = at_vertex ? random.whole(0, 1) : random.share(),
         b = at_vertex ? 0 : random.between(0, 1 - a);
  if (at_vertex && a == 0) b = random.whole(0, 1);
  const auto at = [&](int dc, int dr) {
    return to_profile_frame(view, grid.vertex_m(c + dc, r + dr));
  };
  const ProfilePoint p = at(0, 0), q = at(1, 1), s = upper ? at(1, 0) : at(0, 1);
  const ProfilePoint out{p.u + a * (q.u - p.u) + b * (s.u - p.u),
                         p.v + a * (q.v - p.v) + b * (s.v - p.v),
                         p.z + a * (q.z - p.z) + b * (s.z - p.z)};
  if (std::isnan(p.z + q.z + s.z)) return std::nullopt;
  return out;
}

void ask_left_out(const Grid& grid, const Sector& sector, const SeenGround& ground, Random& random,
                  Tally& tally) {
  const View& view = sector.view;
  const RayWalk walk(grid, view);
  const XRange page = page_range(sector);
  for (int i = 0; i < kPoints; ++i) {
    const int column = random.whole(0, ground.columns - 1), row = random.whole(0, ground.rows - 1);
    if (ground.seen[ground.index(column, row)] != 0) continue;
    const std::optional<ProfilePoint> p = point_in(grid, column, row, view, random);
    if (!p) continue;
    if (view.is_perspective() && p->v < view.near_m) {
      ++tally.beside;
      continue;
    }
    const Vec2 at = project(view, *p);
    if (at.x < page.begin || at.x > page.end) {
      ++tally.beside;
      continue;
    }
    ++tally.asked;
    CAPTURE(p->u, p->v, p->z, at.x, at.y);
    REQUIRE(walk.in_front(*p).greatest_y > at.y);
  }
}

} // namespace

void ask(const RandomScene& made, Random& random, Tally& tally) {
  const PlacedView scene = placed_view(made.terrain, made.spec);
  const auto ground = ground_of_sectors(made.terrain, scene, made.spec.style, kAlways);
  REQUIRE(ground.size() == scene.sectors.size());
  for (std::size_t i = 0; i < ground.size(); ++i)
    ask_left_out(grid_of(made.terrain), scene.sectors[i], ground[i], random, tally);
  tally.left_out += 1 - looked_at_by_any(ground)->share();
  ++tally.scenes;
  const auto draw = [&](const Instruments& instruments) {
    return draw_map(
               made.terrain, scene, made.spec, [](double) {}, instruments)
        .drawing;
  };
  REQUIRE(difference(draw(kAlways), draw({.hidden_ground = true})) == "");
}

void report(const Tally& tally) {
  WARN(tally.scenes << " scenes, " << tally.left_out / static_cast<double>(tally.scenes)
                    << " of the ground left out, " << tally.asked << " points of it asked, "
                    << tally.beside << " beside the page; " << tally.refused << " refused");
}

TEST_CASE("what isn't looked at isn't seen", "[slow]") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    Random random(seed + 40000);
    const RandomScene made = large_scene(seed, random);
    CAPTURE(seed, made.what);
    try {
      ask(made, random, tally);
    } catch (const Error&) {
      ++tally.refused; // the height below the eye rounds to above it
    }
  }
  report(tally);
  CHECK(tally.refused < kScenes / 10);
  CHECK(tally.asked > 10 * kScenes);
}

TEST_CASE("nor in degrees, nor all round", "[slow]") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    Random random(seed + 41000);
    RandomScene made = large_earth_scene(seed, random);
    CAPTURE(seed, made.what);
    try {
      stand_on_earth(made.terrain, made.spec.view);
      ask(made, random, tally);
    } catch (const Error&) {
      ++tally.refused;
    }
  }
  report(tally);
  CHECK(tally.refused < kScenes / 10);
  CHECK(tally.asked > 10 * kScenes);
}

// So wide that many vertices share a column of the bound on the horizon.
TEST_CASE("nor what narrow peaks stand in front of", "[slow]") {
  const std::uint64_t kWide = std::max<std::uint64_t>(kScenes / 30, 1);
  Tally tally;
  for (std::uint64_t seed = 1; seed <= kWide; ++seed) {
    Random random(seed);
    TerrainData terrain;
    Grid grid;
    grid.columns = 5000;
    grid.rows = 120;
    grid.plane() = {{0, 0}, {10, 0}, {0, -10}};
    std::vector<float> heights(grid.size());
    std::vector<bool> is_gap(static_cast<std::size_t>(grid.columns));
    for (std::size_t column = 0; column < is_gap.size(); ++column)
      is_gap[column] = random.chance(0.02);
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        // A palisade along the middle, with gaps, and lower ground behind it.
        const bool peak = row >= 60 && row < 90 && !is_gap[static_cast<std::size_t>(column)];
        heights[grid.index(column, row)] =
            static_cast<float>(peak ? random.between(300, 310) : random.between(0, 40));
      }
    grid.heights_m = std::move(heights);
    terrain.surface = grid;
    MapSpec spec;
    spec.view.projection = random.pick({Projection::orthographic, Projection::perspective});
    spec.view.from_azimuth = Angle::degrees(random.pick({180.0, 175.0}));
    spec.view.from_elevation = Angle::degrees(2);
    spec.view.exaggeration = 1;
    spec.style.plan = ProfileCount{40};
    const PlacedView scene = placed_view(terrain, spec);
    const auto ground = ground_of_sectors(terrain, scene, spec.style, kAlways);
    tally.left_out += 1 - looked_at_by_any(ground)->share();
    ask_left_out(grid, scene.sectors[0], ground[0], random, tally);
    const auto draw = [&](const Instruments& instruments) {
      return draw_map(
                 terrain, scene, spec, [](double) {}, instruments)
          .drawing;
    };
    CAPTURE(seed);
    REQUIRE(difference(draw(kAlways), draw({.hidden_ground = true})) == "");
  }
  CHECK(tally.left_out > 0.05 * static_cast<double>(kWide));
  CHECK(tally.asked > kWide);
}

// A hill that falls by 60 m in 16 cells of 10 m, 20.6 degrees, on both sides of its summit line.
TEST_CASE("hidden ground is looked for where ridges hide much, or where there are voids") {
  TerrainData terrain;
  Grid grid;
  grid.columns = 100;
  grid.rows = 161;
  grid.plane() = {{0, 0}, {10, 0}, {0, -10}};
  std::vector<float> heights(grid.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      heights[grid.index(column, row)] = static_cast<float>(60.0 / 16 * (80 - std::abs(row - 80)));
  const auto finds = [&](double elevation_deg) {
    grid.heights_m = Heights<float>(heights);
    terrain.surface = grid;
    MapSpec spec;
    spec.view.projection = Projection::orthographic;
    spec.view.from_elevation = Angle::degrees(elevation_deg);
    spec.view.exaggeration = 1;
    return !ground_of_sectors(terrain, placed_view(terrain, spec), spec.style, {}).empty();
  };
  CHECK(finds(19));
  CHECK(!finds(22));
  for (int row = 0; row < 30; ++row)
    for (int column = 0; column < grid.columns; ++column)
      heights[grid.index(column, row)] = std::numeric_limits<float>::quiet_NaN();
  CHECK(finds(22));
}

TEST_CASE("ground that is tied to what stands in front of it is looked at") {
  TerrainData terrain;
  Grid grid;
  grid.columns = 80;
  grid.rows = 200;
  grid.plane() = {{0, 0}, {10, 0}, {0, -10}};
  std::vector<float> heights(grid.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      heights[grid.index(column, row)] = row > 150 ? 0.0F : row > 100 ? 100.0F : 99.9F;
  grid.heights_m = std::move(heights);
  terrain.surface = grid;
  MapSpec spec;
  spec.view.projection = Projection::orthographic;
  spec.view.from_azimuth = Angle::degrees(180);
  spec.view.from_elevation = Angle::degrees(0);
  spec.view.exaggeration = 1;
  spec.style.flat = FlatGround::draw;
  const auto share = [&](double tolerance_mm) {
    spec.style.visibility_tolerance_mm = tolerance_mm;
    const PlacedView scene = placed_view(terrain, spec);
    return looked_at_by_any(ground_of_sectors(terrain, scene, spec.style, kAlways))->share();
  };
  CHECK(share(0) < 0.7); // what is 0.1 m below the brink, a twentieth of a millimetre on the page
  CHECK(share(0.5) == 1);
}

} // namespace orograph::seen_ground_test
