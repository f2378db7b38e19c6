// SPDX-License-Identifier: GPL-3.0-or-later
// Made scenes seen in turn from outside, straight or steeply down, and by eyes on the ground.
#pragma once

#include "geometry/error.hpp"
#include "placing/placed_view.hpp"
#include "tests/scenes/look_down.hpp"
#include "tests/scenes/put_eye.hpp"
#include "tests/support/grid_of.hpp"
#include "tests/support/random.hpp"

#include <cstdint>
#include <optional>

namespace orograph {

/// The view of every third scene stays as it is.
inline void vary_view(std::uint64_t seed, const TerrainData& terrain, MapSpec& spec,
                      Random& random) {
  if (seed % 3 == 1) look_down(spec, terrain, random);
  if (seed % 3 == 2) put_eye(spec, grid_of(terrain), random);
}

/// None where it is refused: an eye under the ground, or a view of nothing.
inline std::optional<PlacedView> placed_if_any(const TerrainData& terrain, const MapSpec& spec) {
  try {
    return placed_view(terrain, spec);
  } catch (const Error&) {
    return std::nullopt;
  }
}

} // namespace orograph
