// SPDX-License-Identifier: GPL-3.0-or-later
#include "data_samples/noise.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

// Integers only: the same numbers everywhere. The constants are those of the "lowbias32" hash.
std::uint32_t hash(std::int32_t x, std::int32_t y, std::uint32_t seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9e3779b1u ^
                    static_cast<std::uint32_t>(y) * 0x85ebca77u ^ seed * 0xc2b2ae3du;
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  return h ^ h >> 16;
}

// Two numbers in [-0.5, 0.5).
Vec2 scatter(std::int32_t x, std::int32_t y, std::uint32_t seed) {
  const std::uint32_t h = hash(x, y, seed);
  return {(h & 0xffffu) / 65536. - 0.5, (h >> 16) / 65536. - 0.5};
}

// A cosine's shape with period 1, in arithmetic that rounds alike everywhere.
double wave(double t) {
  const double from_crest = std::abs(t - std::floor(t + 0.5));
  const double x = 1 - 4 * from_crest;
  return 0.5 * x * (3 - x * x);
}

double wave_slope(double t) {
  const double from_crest = t - std::floor(t + 0.5);
  const double x = 1 - 4 * std::abs(from_crest);
  return (from_crest < 0 ? 6 : -6) * (1 - x * x);
}

} // namespace

Sloped gradient_noise(Vec2 at, std::uint32_t seed) {
  const double cell_x = std::floor(at.x), cell_y = std::floor(at.y);
  const auto i = static_cast<std::int32_t>(cell_x), j = static_cast<std::int32_t>(cell_y);
  const Vec2 f{at.x - cell_x, at.y - cell_y};
  const auto corner = [&](int right, int up) {
    const Vec2 gradient = 4. * scatter(i + right, j + up, seed);
    return Sloped{dot(gradient, f - Vec2{double(right), double(up)}), gradient};
  };
  const Sloped a = corner(0, 0), b = corner(1, 0), c = corner(0, 1), d = corner(1, 1);
  // The quintic fade, which has a continuous second derivative, so that slopes have no creases.
  const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const auto fade_slope = [](double t) { return 30 * t * t * (t * (t - 2) + 1); };
  const Vec2 u{fade(f.x), fade(f.y)}, du{fade_slope(f.x), fade_slope(f.y)};
  const double twist = a.value - b.value - c.value + d.value;
  const double east = b.value - a.value, north = c.value - a.value;
  Sloped noise;
  noise.value = a.value + u.x * east + u.y * north + u.x * u.y * twist;
  noise.slope = a.slope + u.x * (b.slope - a.slope) + u.y * (c.slope - a.slope) +
                u.x * u.y * (a.slope - b.slope - c.slope + d.slope) +
                Vec2{du.x * (east + u.y * twist), du.y * (north + u.x * twist)};
  return noise;
}

Sloped fractal_noise(Vec2 at, std::uint32_t seed, int octaves, double gain) {
  Sloped sum;
  double height = 1, frequency = 1;
  for (int octave = 0; octave < octaves; ++octave) {
    const Sloped one = gradient_noise(frequency * at, seed + static_cast<std::uint32_t>(octave));
    sum.value += height * one.value;
    sum.slope = sum.slope + height * frequency * one.slope;
    height *= gain;
    // Not exactly 2, so that the zeros of the octaves don't fall together.
    frequency *= 1.97;
  }
  return sum;
}

Sloped gullies(Vec2 at, Vec2 across, std::uint32_t seed) {
  constexpr double radius_squared = 1.5 * 1.5; // of a cell's reach: its scatter stays within 4 x 4
  const double cell_x = std::floor(at.x), cell_y = std::floor(at.y);
  const auto i = static_cast<std::int32_t>(cell_x), j = static_cast<std::int32_t>(cell_y);
  Sloped sum;
  double weights = 0;
  for (int dj = -1; dj <= 2; ++dj)
    for (int di = -1; di <= 2; ++di) {
      const Vec2 centre = Vec2{cell_x + di, cell_y + dj} + scatter(i + di, j + dj, seed);
      const Vec2 from_centre = at - centre;
      const double near = 1 - dot(from_centre, from_centre) / radius_squared;
      if (near <= 0) continue;
      const double weight = near * near * near * near;
      const double phase = dot(from_centre, across);
      sum.value += weight * wave(phase);
      sum.slope = sum.slope + weight * wave_slope(phase) * across;
      weights += weight;
    }
  return {sum.value / weights, (1 / weights) * sum.slope};
}

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0., 1.);
  return t * t * (3 - 2 * t);
}

} // namespace orograph
