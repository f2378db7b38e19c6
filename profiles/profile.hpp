// SPDX-License-Identifier: GPL-3.0-or-later
// One profile: the terrain cut by a vertical plane of constant depth.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace orograph {

/// What lies between a profile's vertex and the next one.
enum class Span : std::uint8_t {
  gap,   ///< no terrain
  slope, ///< terrain
  level, ///< terrain that belongs to level ground (a sea, a lake)
  wall   ///< straight up or down a vertical triangle that the eye sees
};

/// A part of a profile.
struct URange {
  double low_m = -std::numeric_limits<double>::infinity();
  double high_m = std::numeric_limits<double>::infinity();
};

constexpr std::array<URange, 1> kAllOfProfile{};

/// Vertices from left to right in the profile frame. `after[i]` tells what is between vertex i and
/// i + 1; the last is a gap.
struct Profile {
  double depth_m = 0;
  std::vector<double> u_m; ///< never falling
  std::vector<double> z_m; ///< exaggerated
  std::vector<Span> after;

  std::size_t size() const { return u_m.size(); }
  /// What is beyond the size so far is left to be filled.
  void resize(std::size_t count) {
    u_m.resize(count);
    z_m.resize(count);
    after.resize(count);
  }
  void clear() {
    u_m.clear();
    z_m.clear();
    after.clear();
  }
};

} // namespace orograph
