// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/random_scene.hpp"

#include "data_samples/terrains.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// A window of a made terrain with a grid of its own, not square, possibly turned.
Grid window_of(MadeTerrain made, int most, Random& random) {
  Grid grid;
  grid.columns = random.whole(10, most);
  grid.rows = random.whole(10, most);
  const double step = side_m(made) / random.between(20, 80) * (36.0 / most);
  const double turn = random.chance(0.3) ? random.between(-0.7, 0.7) : 0;
  const double row_step = random.chance(0.5) ? step : step * random.between(0.5, 2);
  grid.plane().first_vertex_m = {random.between(-1000, 1000), random.between(-1000, 1000)};
  grid.plane().column_step_m = {step * std::cos(turn), step * std::sin(turn)};
  grid.plane().row_step_m = {row_step * std::sin(turn), -row_step * std::cos(turn)};
  const Vec2 corner{random.between(0.2, 0.5) * side_m(made),
                    random.between(0.5, 0.8) * side_m(made)};
  std::vector<float> heights(grid.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Vec2 at = grid.plane().position_m(column, row) - grid.plane().first_vertex_m;
      heights[grid.index(column, row)] = static_cast<float>(made_height_m(made, corner + at));
    }
  grid.heights_m = std::move(heights);
  return grid;
}

void roughen(Grid& grid, Random& random, std::string& what) {
  const auto heights = std::get<Heights<float>>(grid.heights_m).own();
  if (random.chance(0.25)) { // a plateau: level ground at some height and above
    const float top =
        heights[static_cast<std::size_t>(random.whole(0, static_cast<int>(grid.size()) - 1))];
    for (float& h : heights) h = std::min(h, top);
    what += ", plateau";
  }
  if (random.chance(0.25)) {
    for (float& h : heights) h = std::round(h / 50) * 50;
    what += ", steps of 50 m";
  }
  if (random.chance(0.25)) {
    const int holes = random.whole(1, 20);
    for (int i = 0; i < holes; ++i) {
      const int size = random.whole(1, 4), column = random.whole(0, grid.columns - 1),
                row = random.whole(0, grid.rows - 1);
      for (int r = row; r < std::min(row + size, grid.rows); ++r)
        for (int c = column; c < std::min(column + size, grid.columns); ++c)
          heights[grid.index(c, r)] = std::numeric_limits<float>::quiet_NaN();
    }
    what += ", holes";
  }
  // A terrain needs one whole triangle.
  for (const auto& [c, r] : {std::pair{0, 0}, {1, 0}, {1, 1}})
    if (std::isnan(heights[grid.index(c, r)])) heights[grid.index(c, r)] = 100;
}

} // namespace

RandomScene random_scene(std::uint64_t seed, int most) {
  Random random(seed);
  RandomScene scene;
  const MadeTerrain made = all_made_terrains[seed % all_made_terrains.size()];
  scene.what = name_of(made);
  grid_of(scene.terrain) = window_of(made, most, random);
  roughen(grid_of(scene.terrain), random, scene.what);

  MapSpec& spec = scene.spec;
  const double along = 90 * random.whole(0, 3);
  const int kind = random.whole(0, 3);
  spec.view.from_azimuth = Angle::degrees(kind == 0   ? along
                                          : kind == 1 ? along + 45
                                                      : random.between(0, 360));
  spec.view.projection = random.chance(0.5) ? Projection::perspective : Projection::orthographic;
  const bool perspective = spec.view.projection == Projection::perspective;
  if (!perspective && random.chance(0.4)) {
    spec.view.projection = Projection::oblique;
    spec.view.oblique =
        random.pick({kCavalier, kCabinet, kMilitary,
                     Oblique{random.between(0.2, 1.5), Angle::degrees(random.between(0, 180))}});
  }
  spec.view.from_elevation = Angle::degrees(random.chance(0.1) ? 0
                                            : random.chance(0.1) && !perspective
                                                ? 90
                                                : random.between(0, perspective ? 50 : 90));
  spec.view.exaggeration = random.chance(0.5) ? 1 : random.between(0.5, 4);
  spec.style.plan = ProfileCount{random.whole(5, 40)};
  scene.what += perspective                                        ? ", perspective"
                : spec.view.projection == Projection::orthographic ? ", orthographic"
                                                                   : ", oblique";
  return scene;
}

} // namespace orograph
