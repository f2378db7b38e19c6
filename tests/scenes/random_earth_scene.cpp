// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/random_earth_scene.hpp"

#include "data_samples/terrains.hpp"
#include "dem/extent.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/made_earth_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orograph {
namespace {

// Whole 1024ths of degrees, so that terrains can be turned without rounding.
MadeEarth lattice_of(Random& random, int most) {
  MadeEarth made;
  made.columns = random.whole(10, most);
  made.rows = random.whole(10, most);
  if (random.chance(0.3)) {
    made.ellipsoid = {random.pick({2e4, 2e5}), random.pick({298.257223563, 0.0, 20.0})};
    made.lon_step_deg = random.whole(50, 300) / 1024.0;
  } else {
    made.lon_step_deg = random.pick({1, 4, 10, 100}) / 1024.0 / random.pick({1, 4});
  }
  made.lat_step_deg = random.chance(0.7) ? made.lon_step_deg : made.lon_step_deg / 2;
  made.north_deg = random.whole(-70 * 64, 80 * 64) / 64.0;
  made.west_deg = random.chance(0.3) ? 180 - made.lon_step_deg * random.whole(0, made.columns)
                                     : random.whole(-180 * 64, 360 * 64) / 64.0;
  made.origin_lon_deg = made.west_deg + made.lon_step_deg * (made.columns - 1) / 2;
  made.origin_lat_deg = made.north_deg - made.lat_step_deg * (made.rows - 1) / 2;
  return made;
}

// A window of a made terrain, as rough for its size, up to that of mountains.
std::vector<float> heights_of(MadeTerrain terrain, const MadeEarth& made, double cell_m,
                              Random& random) {
  const double side = side_m(terrain), step = side / random.between(20, 80);
  const double unit = std::min(cell_m / step, 2.0) * random.between(0.3, 1.5);
  const Vec2 corner{random.between(0.2, 0.5) * side, random.between(0.5, 0.8) * side};
  std::vector<float> heights;
  for (int row = 0; row < made.rows; ++row)
    for (int column = 0; column < made.columns; ++column)
      heights.push_back(static_cast<float>(
          unit * made_height_m(terrain, corner + Vec2{column * step, -row * step})));
  return heights;
}

void roughen(std::vector<float>& heights, const MadeEarth& made, Random& random,
             std::string& what) {
  if (random.chance(0.2)) {
    const float top =
        heights[static_cast<std::size_t>(random.whole(0, static_cast<int>(heights.size()) - 1))];
    for (float& h : heights) h = std::min(h, top);
    what += ", plateau";
  }
  if (random.chance(0.2)) {
    for (float& h : heights) h = std::round(h / 50) * 50;
    what += ", steps of 50 m";
  }
  if (random.chance(0.33)) {
    make_gaps(random, made.columns, made.rows, heights);
    what += ", gaps";
  }
  // A terrain needs one whole triangle.
  const auto columns = static_cast<std::size_t>(made.columns);
  for (const std::size_t i : {std::size_t{0}, columns, columns + 1})
    if (std::isnan(heights[i])) heights[i] = 100;
}

TerrainData terrain_of(MadeTerrain kind, int most, Random& random, std::string& what) {
  const MadeEarth made = lattice_of(random, most);
  TerrainData terrain;
  Grid grid;
  grid.columns = made.columns;
  grid.rows = made.rows;
  grid.lattice = earth_lattice(made);
  std::vector<float> heights = heights_of(kind, made, cell_size_m(grid), random);
  roughen(heights, made, random, what);
  grid.heights_m = std::move(heights);
  terrain.source = "made";
  terrain.map.origin = {made.origin_lon_deg, made.origin_lat_deg};
  terrain.map.earth = EarthFrame{grid.earth().frame(), 1, 1};
  terrain.map.radii =
      CurvatureRadii{euler_radius_m(made.ellipsoid, made.origin_lat_deg, Angle()),
                     euler_radius_m(made.ellipsoid, made.origin_lat_deg, Angle::degrees(90))};
  terrain.surface = std::move(grid);
  return terrain;
}

// On a map: of a place by column and row; in whole parts of a degree, so that it can be turned
// without rounding.
Vec2 place_of(const Grid& grid, double column, double row) {
  const DegreeLattice& lattice = grid.earth().degrees();
  const auto whole = [](double deg) { return std::round(deg * 0x1p30) / 0x1p30; };
  return {whole(lattice.first_lon_deg + column * lattice.lon_step_deg),
          whole(lattice.first_lat_deg + row * lattice.lat_step_deg)};
}

// Over a triangle that is there; at its first vertex, or within.
Vec2 on_ground(const Grid& grid, Random& random, bool at_vertex) {
  const std::vector<GridTriangle> triangles = triangles_of(grid);
  const GridTriangle& t =
      triangles[static_cast<std::size_t>(random.whole(0, static_cast<int>(triangles.size()) - 1))];
  if (at_vertex) return place_of(grid, t.column, t.row);
  const double near = random.between(0.05, 0.45), far = random.between(0.5, 0.95);
  return t.half == Half::lower ? place_of(grid, t.column + near, t.row + far)
                               : place_of(grid, t.column + far, t.row + near);
}

Vec2 anywhere(const Grid& grid, Random& random, double beyond) {
  return place_of(grid, random.between(-beyond, 1 + beyond) * (grid.columns - 1),
                  random.between(-beyond, 1 + beyond) * (grid.rows - 1));
}

void frame_terrain(MapSpec& spec, Random& random) {
  spec.view.projection = random.pick({Projection::perspective, Projection::perspective,
                                      Projection::orthographic, Projection::oblique});
  if (spec.view.projection == Projection::oblique)
    spec.view.oblique =
        random.pick({kCavalier, kCabinet, kMilitary,
                     Oblique{random.between(0.2, 1.5), Angle::degrees(random.between(0, 180))}});
  spec.view.from_azimuth =
      Angle::degrees(random.chance(0.3) ? 45.0 * random.whole(0, 7) : random.between(0, 360));
  const bool perspective = spec.view.projection == Projection::perspective;
  spec.view.from_elevation = Angle::degrees(random.chance(0.1) ? 0
                                            : random.chance(0.1) && !perspective
                                                ? 90
                                                : random.between(0, perspective ? 50 : 90));
}

void look_at_something(MapSpec& spec, const Grid& grid, Random& random) {
  if (random.chance(0.5)) {
    spec.view.look_azimuth =
        Angle::degrees(random.chance(0.3) ? 45.0 * random.whole(0, 7) : random.between(0, 360));
    spec.view.pitch = Angle::degrees(random.pick({0.0, -5.0, random.between(-30, 10)}));
  } else {
    const Vec2 target = on_ground(grid, random, random.chance(0.5));
    spec.view.look_at_map = GivenPlace(target.x, target.y);
  }
  spec.view.field_of_view = Angle::degrees(random.pick({30.0, 60.0, 100.0}));
}

} // namespace

RandomScene random_earth_scene(std::uint64_t seed, Stand stand, int most) {
  Random random(seed + 1000000 * static_cast<std::uint64_t>(stand));
  RandomScene scene;
  const MadeTerrain kind = all_made_terrains[seed % all_made_terrains.size()];
  scene.what = name_of(kind);
  scene.terrain = terrain_of(kind, most, random, scene.what);
  const Grid& grid = grid_of(scene.terrain);
  MapSpec& spec = scene.spec;
  spec.view.exaggeration = random.pick({1.0, 1.0, 3.0});
  spec.view.refraction = random.pick({0.0, 0.13, 0.5});
  spec.view.curvature = random.pick({Curvature::automatic, Curvature::on});
  spec.style.plan = ProfileCount{random.whole(5, 40)};
  spec.view.roll = Angle::degrees(random.pick({0.0, 0.0, random.between(-90, 90)}));
  const double wide_m = cell_size_m(grid) * std::max(grid.columns, grid.rows);
  const auto [low, high] = std::visit(
      [](const auto& heights) {
        double least = INFINITY, greatest = -INFINITY;
        for (const double h : heights) { // fmin and fmax leave out a NaN
          least = std::fmin(least, h);
          greatest = std::fmax(greatest, h);
        }
        return std::pair(least, greatest);
      },
      grid.heights_m);
  if (stand == Stand::frames_terrain) {
    frame_terrain(spec, random);
    return scene;
  }
  spec.view.projection = Projection::perspective;
  Vec2 eye = on_ground(grid, random, random.chance(0.5));
  if (stand == Stand::on_ground) {
    spec.view.eye_map = GivenPlace(eye.x, eye.y);
    spec.view.eye_height_m = random.pick({0.0, 0.001, 2.0, 100.0});
    look_at_something(spec, grid, random);
  } else if (stand == Stand::in_air) {
    eye = anywhere(grid, random, random.pick({-0.2, 1.0}));
    spec.view.eye_map = Vec3{eye.x, eye.y, high + wide_m * random.pick({0.001, 0.05, 0.3})};
    const Vec2 target = on_ground(grid, random, random.chance(0.5));
    spec.view.look_at_map = GivenPlace(target.x, target.y);
    spec.view.field_of_view = Angle::degrees(random.pick({30.0, 60.0, 100.0}));
  } else {
    if (random.chance(0.6)) eye = anywhere(grid, random, 0.1);
    spec.view.eye_map = Vec3{eye.x, eye.y, high + wide_m * random.pick({0.01, 0.2, 1.0})};
    const Vec2 target = random.chance(0.4) ? eye : anywhere(grid, random, -0.3);
    spec.view.look_at_map = Vec3{target.x, target.y, low};
    spec.view.from_azimuth = Angle::degrees(random.pick({0.0, 90.0, random.between(0, 360)}));
    spec.view.field_of_view = Angle::degrees(random.pick({60.0, 120.0, 170.0}));
  }
  return scene;
}

} // namespace orograph
