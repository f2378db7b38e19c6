// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/stability/hard_families.hpp"

#include "dem/height_at.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace orograph {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Heights by column and row on cells of so many metres, the first row in the north.
template <class Height>
HardScene lattice(Random& random, double cell_m, const Height& height) {
  HardScene scene;
  Grid grid;
  grid.columns = random.whole(3, 8);
  grid.rows = random.whole(3, 8);
  grid.lattice = PlaneLattice{{0, 0}, {cell_m, 0}, {0, -cell_m}};
  std::vector<double> heights;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) heights.push_back(height(column, row));
  // A terrain has one triangle at least.
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}, grid.index(1, 1)})
    if (std::isnan(heights[i])) heights[i] = 0;
  grid.heights_m = Heights<double>(std::move(heights));
  scene.terrain.surface = std::move(grid);

  MapSpec& spec = scene.spec;
  spec.view.exaggeration = 1;
  spec.view.projection = random.chance(0.5) ? Projection::perspective : Projection::orthographic;
  spec.view.from_azimuth = Angle::degrees(random.chance(0.4)   ? 45.0 * random.whole(0, 7)
                                          : random.chance(0.3) ? 90.0 * random.whole(0, 3) + 1e-9
                                                               : random.between(0, 360));
  spec.view.from_elevation = Angle::degrees(random.between(0, 50));
  spec.style.plan = ProfileCount{random.whole(2, 6)};
  return scene;
}

HardScene rough(Random& random) {
  const double cell_m = random.pick({1.0, 30.0});
  return lattice(random, cell_m, [&](int, int) { return cell_m * random.share(); });
}

void look_parallel(HardScene& scene, double elevation_deg) {
  scene.spec.view.projection = Projection::orthographic;
  scene.spec.view.from_elevation = Angle::degrees(elevation_deg);
}

HardScene needles(Random& random) {
  const double highest_m = std::pow(10, random.whole(2, 6));
  return lattice(random, 30, [&](int, int) { return highest_m * random.share(); });
}

// All heights in one plane, or in two that meet, seen edge-on or nearly.
HardScene sheets(Random& random) {
  const double slope = random.pick({0.0, 0.5, 1.0, 2.0});
  const double beside = random.pick({0.0, 1e-15, 1e-12, 1e-9});
  const int bend = random.whole(0, 8);
  HardScene scene = lattice(random, 1, [&](int, int row) {
    return slope * std::abs(row - bend) + beside * random.between(-1, 1);
  });
  scene.spec.view.from_azimuth = Angle::degrees(180.0 * random.whole(0, 1));
  look_parallel(scene, std::atan(slope) * 180 / M_PI);
  return scene;
}

HardScene checkerboards(Random& random) {
  const double high_m = random.pick({1e-6, 0.1, 1.0, 100.0});
  HardScene scene = lattice(
      random, 1, [&](int column, int row) { return (column + row) % 2 == 0 ? high_m : 0.0; });
  return scene;
}

HardScene whole_numbers(Random& random) {
  const int highest = random.whole(1, 4);
  return lattice(random, 1,
                 [&](int, int) { return static_cast<double>(random.whole(0, highest)); });
}

HardScene ulps(Random& random) {
  const double height_m = random.pick({1.0, 100.0, 8848.86});
  return lattice(random, random.pick({1.0, 30.0}), [&](int, int) {
    return height_m * (1 + random.whole(-3, 3) * std::numeric_limits<double>::epsilon());
  });
}

HardScene huge_numbers(Random& random) {
  const double size = std::pow(10, random.whole(6, 15));
  return lattice(random, size, [&](int, int) { return size * random.share(); });
}

HardScene tiny_numbers(Random& random) {
  const double size = std::pow(10, -random.whole(3, 12));
  return lattice(random, size, [&](int, int) { return size * random.share(); });
}

HardScene far_from_origin(Random& random) {
  HardScene scene = rough(random);
  auto& lattice = std::get<PlaneLattice>(std::get<Grid>(scene.terrain.surface).lattice);
  lattice.first_vertex_m = {random.between(-1e7, 1e7), random.between(-1e7, 1e7)};
  return scene;
}

HardScene denormals(Random& random) {
  return lattice(random, 1, [&](int, int) {
    return random.chance(0.2) ? -0.0
                              : std::numeric_limits<double>::denorm_min() * random.whole(-4, 8);
  });
}

HardScene steep(Random& random) {
  const double cell_m = random.pick({1e-3, 1.0});
  return lattice(random, cell_m, [&](int, int) {
    return random.chance(0.4) ? 1e9 * cell_m * random.share() : cell_m * random.share();
  });
}

HardScene from_level(Random& random) {
  HardScene scene = random.chance(0.5) ? rough(random) : whole_numbers(random);
  look_parallel(scene, 0);
  return scene;
}

HardScene from_above(Random& random) {
  HardScene scene = random.chance(0.5) ? rough(random) : whole_numbers(random);
  look_parallel(scene, 90);
  return scene;
}

HardScene from_nearly_level(Random& random) {
  HardScene scene = random.chance(0.5) ? rough(random) : whole_numbers(random);
  look_parallel(scene, 1e-9);
  return scene;
}

HardScene from_nearly_above(Random& random) {
  HardScene scene = random.chance(0.5) ? rough(random) : whole_numbers(random);
  look_parallel(scene, 90 - random.pick({1e-9, 1e-6, 1e-3}));
  return scene;
}

// Profiles through vertices, along rows, columns or diagonals.
HardScene along_the_lattice(Random& random) {
  HardScene scene = random.chance(0.5) ? rough(random) : whole_numbers(random);
  const Grid& grid = std::get<Grid>(scene.terrain.surface);
  const double cell_m = grid.plane().column_step_m.x;
  const bool diagonal = random.chance(0.3);
  scene.spec.view.from_azimuth = Angle::degrees(90.0 * random.whole(0, 3) + (diagonal ? 45 : 0));
  scene.spec.style.plan = GroundSpacing{(diagonal ? std::sqrt(0.5) : 1.0) * cell_m};
  return scene;
}

// An eye on the surface, or little above it, that looks at a vertex.
void put_eye(HardScene& scene, Random& random, Vec2 eye) {
  const Grid& grid = std::get<Grid>(scene.terrain.surface);
  const Vec2 target =
      grid.plane().position_m(random.whole(0, grid.columns - 1), random.whole(0, grid.rows - 1));
  const double ground_m = height_at(grid, eye).value_or(0), cell_m = grid.plane().column_step_m.x;
  ViewSpec& view = scene.spec.view;
  view.projection = Projection::perspective;
  view.eye_map = Vec3{eye.x, eye.y, ground_m + cell_m * random.pick({0.0, 1e-9, 1e-3, 0.3, 2.0})};
  view.look_at_map = Vec3{target.x, target.y, ground_m - cell_m * random.pick({0.0, 0.5, 2.0})};
  view.field_of_view = Angle::degrees(random.pick({30.0, 60.0, 100.0, 160.0}));
}

HardScene eyes_on_vertices(Random& random) {
  HardScene scene = random.chance(0.5) ? rough(random) : whole_numbers(random);
  const Grid& grid = std::get<Grid>(scene.terrain.surface);
  put_eye(
      scene, random,
      grid.plane().position_m(random.whole(0, grid.columns - 1), random.whole(0, grid.rows - 1)));
  return scene;
}

HardScene eyes_on_edges(Random& random) {
  HardScene scene = random.chance(0.5) ? rough(random) : whole_numbers(random);
  const Grid& grid = std::get<Grid>(scene.terrain.surface);
  const Vec2 from =
      grid.plane().position_m(random.whole(0, grid.columns - 2), random.whole(0, grid.rows - 2));
  const auto& [first, column, row] = grid.plane();
  const Vec2 step = random.pick({column, row, column + row});
  put_eye(scene, random, from + random.pick({0.5, 0.25, random.share()}) * step);
  return scene;
}

// Voids that touch at corners, and islands of a triangle.
HardScene voids(Random& random) {
  const bool checkered = random.chance(0.3);
  return lattice(random, 1, [&](int column, int row) {
    const bool is_void = checkered ? column % 2 == 1 && row % 2 == 1 : random.chance(0.2);
    return is_void ? kNone : random.chance(0.5) ? random.share() : random.whole(0, 2) * 1.0;
  });
}

const std::vector<HardFamily> kFamilies{{"needles, 100 m to 1000 km on 30 m", needles},
                                        {"sheets edge-on, bent, off by 1e-15 to 1e-9", sheets},
                                        {"checkerboards", checkerboards},
                                        {"whole numbers", whole_numbers},
                                        {"ulps apart", ulps},
                                        {"cells of 1e6 to 1e15 m", huge_numbers},
                                        {"cells of 1e-3 to 1e-12 m", tiny_numbers},
                                        {"1e7 m from the origin", far_from_origin},
                                        {"denormals and signed zeros", denormals},
                                        {"slopes of 1e9", steep},
                                        {"elevation 0", from_level},
                                        {"elevation 90", from_above},
                                        {"elevation 1e-9", from_nearly_level},
                                        {"elevation 90 less 1e-9 to 1e-3", from_nearly_above},
                                        {"profiles through vertices", along_the_lattice},
                                        {"eyes on vertices", eyes_on_vertices},
                                        {"eyes on edges", eyes_on_edges},
                                        {"voids that touch at corners", voids}};

} // namespace

std::span<const HardFamily> hard_families() {
  return kFamilies;
}

} // namespace orograph
