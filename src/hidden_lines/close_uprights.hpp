// SPDX-License-Identifier: GPL-3.0-or-later
// Upright lines of a block's walls: at which ends of walls they are, and which of them are left out
// because they are close to others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace orograph {

/// Where a wall begins or ends.
enum class Upright : std::uint8_t { none, turned_away, corner };

/// An end of a border's edge at which it turns away from the eye.
struct TurnedAway {
  std::uint32_t edge;
  double at; ///< on the page, to the right
};

/// A border in steps that is seen nearly edge-on turns away at each of them. Of those that follow
/// each other along it, each nearer than `apart` to the one before, the outermost stays, that
/// farthest to the right or to the left. Tells the edges of all others.
std::vector<std::uint32_t> too_close(std::span<const TurnedAway> along, double apart,
                                     bool rightmost_stays);

} // namespace orograph
