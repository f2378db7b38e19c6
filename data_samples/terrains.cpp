// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: `at` in metres, p in units of a terrain's main wavelength.
#include "data_samples/terrains.hpp"

#include "data_samples/noise.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

constexpr double cone_side_m = 4000, plateau_side_m = 12000, saddle_side_m = 6000;
constexpr double ridges_side_m = 30000, alps_side_m = 24000, islands_side_m = 20000;

// Gullies that run down the given slope and branch: each octave follows the slope that the larger
// ones have made, weighted by `branch`. In about [-1, 1]; `frequency` is gullies to a unit of
// length where steepness * slope is 1 or more.
double erosion(Vec2 at, Vec2 slope, double frequency, int octaves, double steepness, double branch,
               std::uint32_t seed) {
  Sloped sum;
  double height = 0.5;
  for (int octave = 0; octave < octaves; ++octave) {
    // Across the slope, so that the crests run down it.
    const Vec2 down = steepness * slope + branch * sum.slope;
    Vec2 across{down.y, -down.x};
    const double size = length(across);
    // Steep slopes have no finer gullies than others.
    if (size > 1) across = (1 / size) * across;
    const Sloped one =
        gullies(frequency * at, across, seed + 100u + static_cast<std::uint32_t>(octave));
    sum.value += height * one.value;
    sum.slope = sum.slope + height * frequency * one.slope;
    height *= 0.45;
    frequency *= 2.03;
  }
  return sum.value;
}

double cone(Vec2 at) {
  constexpr double radius = 1600, height = 1200;
  const double d = length(at - Vec2{cone_side_m / 2, cone_side_m / 2});
  return d < radius ? height * (1 - d / radius) : 0;
}

double saddle(Vec2 at) {
  const Vec2 p = (2 / saddle_side_m) * (at - Vec2{saddle_side_m / 2, saddle_side_m / 2});
  return 800 + 500 * (p.x * p.x - p.y * p.y);
}

double plateau(Vec2 at) {
  const Vec2 centred = at - Vec2{plateau_side_m / 2, plateau_side_m / 2};
  const Sloped bays = fractal_noise((1 / 3500.) * at, 31, 5, 0.5);
  const double edge = 3600 + 1100 * bays.value - length(centred); // metres inside the rim
  const double plain = 300 + 0.01 * at.x + 25 * fractal_noise((1 / 2500.) * at, 41, 5, 0.5).value;
  const double gully =
      erosion((1 / 1500.) * at, (1 / length(centred + Vec2{1, 1})) * centred, 1.5, 4, 1, 0.4, 37);
  const double rise = smooth_step(-1500, 0, edge + 260 * gully * smooth_step(0, -700, edge));
  // Talus below, a cliff at the rim, level above.
  const double side = 0.45 * rise * rise + 0.55 * smooth_step(0.82, 0.97, rise);
  return plain + (1100 - plain) * std::min(1., side);
}

double ridge_and_valley(Vec2 at) {
  constexpr double wavelength = 4300;
  const Vec2 bend = (1 / 11000.) * at;
  const double along = (0.8 * at.x + 0.6 * at.y) / wavelength;
  const double across =
      (-0.6 * at.x + 0.8 * at.y) / wavelength + 0.55 * fractal_noise(bend, 51, 2, 0.4).value;
  const double whole = std::floor(across), t = across - whole;
  // Steeper on one side, as where beds dip.
  const double limb = t < 0.4 ? t / 0.4 : (1 - t) / 0.6;
  const double crest = 0.75 + 0.35 * gradient_noise({along / 2.5, whole * 7.3 + 0.5}, 53).value;
  const double gap = smooth_step(-0.75, -0.5, gradient_noise({along / 1.7, whole * 3.1}, 57).value);
  const double ridge = limb * limb * (3 - 2 * limb) * crest * gap;
  const double facing = t < 0.4 ? 1 : -1;
  const double gully = erosion((1 / 2200.) * at, facing * Vec2{-0.6, 0.8}, 1.6, 4, 1, 0.35, 59);
  const double hills = fractal_noise((1 / 3000.) * at, 61, 6, 0.5).value;
  return 220 + 520 * ridge + 150 * gully * (0.1 + limb * (1 - 0.6 * limb)) + 35 * hills;
}

double fractal_alps(Vec2 at) {
  const Vec2 p = (1 / 9000.) * at;
  const Vec2 bent =
      p + 0.12 * Vec2{gradient_noise(1.7 * p, 5).value, gradient_noise(1.7 * p, 6).value};
  const Sloped massif = fractal_noise(bent, 11, 3, 0.46);
  const double high = smooth_step(-0.75, 0.75, massif.value);
  const double gully = erosion(p, massif.slope, 3.2, 5, 0.8, 0.25, 13);
  // Valley floors fill with what the slopes lose.
  return 600 + 2400 * high + 620 * gully * (0.1 + 0.9 * smooth_step(0.05, 0.6, high));
}

double islands(Vec2 at) {
  const Vec2 p = (1 / 4600.) * at;
  const Vec2 centred = (2 / islands_side_m) * (at - Vec2{islands_side_m / 2, islands_side_m / 2});
  // The sea floor falls towards the border, so that no island is cut there.
  const double depth = 1.2 * smooth_step(0.45, 1.1, length(centred)) - 0.04;
  const double land = fractal_noise(p, 84, 8, 0.5).value - depth;
  if (land <= 0) return 0;
  const Sloped broad = fractal_noise(p, 84, 3, 0.5);
  const double gully = erosion(p, broad.slope, 3, 5, 0.8, 0.3, 73);
  const double inland = smooth_step(0, 0.35, land);
  return std::max(0., 900 * land * (0.45 + inland) + 300 * gully * inland);
}

} // namespace

std::string name_of(MadeTerrain terrain) {
  switch (terrain) {
  case MadeTerrain::cone:
    return "cone";
  case MadeTerrain::plateau:
    return "plateau";
  case MadeTerrain::saddle:
    return "saddle";
  case MadeTerrain::ridge_and_valley:
    return "ridge_and_valley";
  case MadeTerrain::fractal_alps:
    return "fractal_alps";
  case MadeTerrain::islands:
    return "islands";
  }
  return "";
}

double side_m(MadeTerrain terrain) {
  switch (terrain) {
  case MadeTerrain::cone:
    return cone_side_m;
  case MadeTerrain::plateau:
    return plateau_side_m;
  case MadeTerrain::saddle:
    return saddle_side_m;
  case MadeTerrain::ridge_and_valley:
    return ridges_side_m;
  case MadeTerrain::fractal_alps:
    return alps_side_m;
  case MadeTerrain::islands:
    return islands_side_m;
  }
  return 0;
}

double made_height_m(MadeTerrain terrain, Vec2 at_m) {
  switch (terrain) {
  case MadeTerrain::cone:
    return cone(at_m);
  case MadeTerrain::plateau:
    return plateau(at_m);
  case MadeTerrain::saddle:
    return saddle(at_m);
  case MadeTerrain::ridge_and_valley:
    return ridge_and_valley(at_m);
  case MadeTerrain::fractal_alps:
    return fractal_alps(at_m);
  case MadeTerrain::islands:
    return islands(at_m);
  }
  return 0;
}

Grid make_terrain(MadeTerrain terrain, int vertices) {
  const double side = side_m(terrain), step = side / (vertices - 1);
  Grid grid;
  grid.columns = grid.rows = vertices;
  grid.plane().first_vertex_m = {0, side};
  grid.plane().column_step_m = {step, 0};
  grid.plane().row_step_m = {0, -step};
  std::vector<float> heights(grid.size());
  on_all_cores(static_cast<std::size_t>(vertices), [&](std::size_t i) {
    const int row = static_cast<int>(i);
    for (int column = 0; column < vertices; ++column)
      heights[grid.index(column, row)] =
          static_cast<float>(made_height_m(terrain, grid.plane().position_m(column, row)));
  });
  grid.heights_m = std::move(heights);
  return grid;
}

} // namespace orograph
