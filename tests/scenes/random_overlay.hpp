// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/extent.hpp"
#include "dem/overlay.hpp"
#include "dem/terrain.hpp"
#include "tests/support/random.hpp"

namespace orograph {

/// Some lines across a terrain, and points, here and there beside it.
inline Overlay random_overlay(const TerrainData& terrain, Random& random) {
  const Box2 box = map_bounds(terrain);
  Overlay out;
  for (int i = 0; i < 6; ++i) {
    const std::size_t first = out.places.size();
    for (int k = i < 4 ? random.whole(2, 6) : 1; k > 0; --k)
      out.places.push_back({random.between(box.low.x - 0.2 * box.width(), box.high.x),
                            random.between(box.low.y, box.high.y)});
    out.features.push_back({{}, out.lines.size(), 1});
    out.lines.push_back({first, out.places.size() - first});
  }
  return out;
}

} // namespace orograph
