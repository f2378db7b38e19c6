// SPDX-License-Identifier: GPL-3.0-or-later
// Darkness of a page in windows, what is asked of it by a light, and how the two compare.
#pragma once

#include "bench/page/page_ground.hpp"
#include "geometry/angle.hpp"
#include "geometry/box.hpp"
#include "geometry/vec.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace orograph {

/// Darkness, 0 white to 1 black, that a light asks for: `light_side` where the ground faces it,
/// `shadow_side` where it is turned away by a right angle or more.
struct AskedTone {
  Angle azimuth, altitude; ///< of the light: clockwise from north, above the horizontal
  double light_side = 0, shadow_side = 1;

  /// light_side + (shadow_side - light_side) (1 - max(0, n.l))^1.2. REQUIRES a unit normal.
  double darkness(Vec3 normal) const;
};

struct ToneWindow {
  Box2 mm;
  double asked = 0; ///< mean darkness
};
constexpr double kToneWindow_mm = 6;

/// The windows side by side from the frame's upper left corner that show ground all over and half a
/// millimetre around, none of it level. Normals are taken every half millimetre, each smoothed with
/// its neighbours, so that ground counts over about 1 mm. On all cores.
std::vector<ToneWindow> tone_windows(const PageGround& ground, const Box2& frame_mm,
                                     const AskedTone& asked);

/// A page in pixels, row by row from the upper left.
struct PagePixels {
  std::size_t columns = 0, rows = 0;
  double per_mm = 0;
  std::vector<std::uint8_t> levels; ///< 0 black to 255 white

  /// Of the pixels whose middles lie in the box. REQUIRES one.
  double mean_darkness(const Box2& mm) const;
};

/// The first band of an image whose pixels are so many to a millimetre. Throws Error.
PagePixels read_page_pixels(const std::string& path, double per_mm);

/// Spearman's: the correlation of ranks, equal numbers sharing theirs. NaN where all numbers of a
/// side are equal. REQUIRES as many on both sides.
double rank_correlation(std::span<const double> a, std::span<const double> b);
/// The greatest distance of a number from the mean of all, over that mean.
double greatest_departure(std::span<const double> numbers);

} // namespace orograph
