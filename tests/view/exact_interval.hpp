// SPDX-License-Identifier: GPL-3.0-or-later
// Clipping by its definition in exact rational arithmetic: which t of [0, 1] satisfy six linear
// inequalities. Coordinates are multiples of 2^-56 below 2^3 in absolute value (doubles of up to
// 53 digits, whose sums a double can't hold), so values of planes are integers of 60 binary digits,
// and two crossings are compared by products of 120.
#pragma once

#include "view/pipeline.hpp"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstdint>

namespace orograph {

__extension__ typedef __int128 Wide;

/// numerator / denominator, denominator > 0.
struct Share {
  std::int64_t numerator = 0, denominator = 1;

  long double value() const {
    return static_cast<long double>(numerator) / static_cast<long double>(denominator);
  }
};

inline bool less(Share a, Share b) {
  return Wide(a.numerator) * b.denominator < Wide(b.numerator) * a.denominator;
}

constexpr double kUnit = 0x1p-56;

/// The nearest coordinate that the exact clip takes.
inline double on_lattice(double x) {
  return std::nearbyint(x / kUnit) * kUnit;
}

/// What of the edge is inside, if not `empty`: first to last.
struct ExactInterval {
  bool empty = false;
  Share first{0, 1}, last{1, 1};

  /// Length in t; negative where the edge misses the volume by so much.
  long double room() const { return last.value() - first.value(); }
};

/// REQUIRES z_min a multiple of 2^-10 and w of 2^-46.
inline std::array<std::int64_t, 6> exact_values(const Eigen::Vector4d& p,
                                                const CanonicalVolume& volume) {
  const auto whole = [](double x) { return static_cast<std::int64_t>(x / kUnit); };
  const std::int64_t x = whole(p.x()), y = whole(p.y()), z = whole(p.z()), w = whole(p.w());
  const bool perspective = volume.projection == PhigsProjection::perspective;
  const std::int64_t reach = perspective ? -z : w; // -reach <= x <= reach
  const std::int64_t front =
      perspective ? static_cast<std::int64_t>(volume.z_min * 1024) * (w / 1024) : 0;
  return {x + reach, reach - x, y + reach, reach - y, z + w, front - z};
}

inline ExactInterval exact_interval(const Eigen::Vector4d& from, const Eigen::Vector4d& to,
                                    const CanonicalVolume& volume) {
  ExactInterval interval;
  const auto a = exact_values(from, volume), b = exact_values(to, volume);
  for (int i = 0; i < 6; ++i) {
    if (a[i] < 0 && b[i] < 0) interval.empty = true;
    if (a[i] < 0 && b[i] >= 0) {
      const Share crossing{-a[i], b[i] - a[i]};
      if (less(interval.first, crossing)) interval.first = crossing;
    }
    if (a[i] >= 0 && b[i] < 0) {
      const Share crossing{a[i], a[i] - b[i]};
      if (less(crossing, interval.last)) interval.last = crossing;
    }
  }
  if (less(interval.last, interval.first)) interval.empty = true;
  return interval;
}

} // namespace orograph
