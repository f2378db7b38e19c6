// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth noise with its slope, and the pattern that running water leaves on a slope.
#pragma once

#include "geometry/vec.hpp"

#include <cstdint>

namespace orograph {

/// A value and how it changes with x and y.
struct Sloped {
  double value = 0;
  Vec2 slope;
};

/// Gradient noise in about [-1, 1], zero at whole numbers, of wavelength about 1.
Sloped gradient_noise(Vec2 at, std::uint32_t seed);

/// Sum of `octaves` noises, each of half the wavelength and `gain` times the height of the last.
Sloped fractal_noise(Vec2 at, std::uint32_t seed, int octaves, double gain);

/// Parallel waves, in [-1, 1], that follow each other in the direction `across` and bend where it
/// changes; as many to a unit of length as `across` is long.
Sloped gullies(Vec2 at, Vec2 across, std::uint32_t seed);

/// From 0 at `low` and below to 1 at `high` and above, without a kink.
double smooth_step(double low, double high, double x);

} // namespace orograph
