// SPDX-License-Identifier: GPL-3.0-or-later
// Which names count for more.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace orograph {

/// What is known of a summit that has a name.
struct NamedSummit {
  std::string_view text;
  double height_m = 0;              ///< the DEM's
  double east = 0, north = 0;       ///< the place, in map coordinates
  double stature = 0;               ///< as `stature` has it, or a field's weight
  std::optional<double> distance_m; ///< from the eye; none: all are as near
};

/// How much a summit stands out, in metres: by the ground on both sides of it, and less by its
/// prominence, which says nothing of what one sees.
constexpr double stature(double dominance_m, double prominence_m) {
  return dominance_m + 0.3 * prominence_m;
}

/// What sums of names are compared by: by value, and among equals by places in the order of ranks.
struct NameWeight {
  std::int64_t value = 0, places = 0;

  auto operator<=>(const NameWeight&) const = default;
  NameWeight operator+(const NameWeight& other) const {
    return {value + other.value, places + other.places};
  }
};

struct RankedNames {
  std::vector<std::size_t> order;  ///< first what counts most
  std::vector<NameWeight> weights; ///< of each summit, above 0
};

/// A summit's rank is its stature, which fades with distance: times exp(-d / haze) / sqrt(d), and
/// over that where it is negative. Equal ranks: the higher summit is first, then by place and name,
/// never by the order in which they are given. Values are ranks in whole steps of 2^-40 of the
/// greatest, so that sums of them are exact; those of no more than 0 are 0. REQUIRES fewer than
/// 2^22 summits.
RankedNames ranked(std::span<const NamedSummit> summits, double haze_m);

} // namespace orograph
