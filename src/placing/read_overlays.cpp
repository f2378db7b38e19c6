// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/read_overlays.hpp"

#include "geometry/error.hpp"
#include "placing/terrain_facts.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {

std::vector<Overlay> read_overlays(std::span<const OverlayInput> inputs,
                                   const TerrainData& terrain) {
  std::vector<Overlay> out;
  if (inputs.empty()) return out;
  if (!has_ground(terrain.surface))
    throw Error("there is no terrain to lay " + inputs.front().path + " on", "give a DEM or a TIN");
  const Box2 bounds = map_bounds(terrain);
  // A cell's side, or what it would be if the vertices were a square grid's.
  const double cell = std::max(bounds.width(), bounds.height()) /
                      std::sqrt(static_cast<double>(vertex_count(terrain.surface)));
  for (const OverlayInput& input : inputs)
    out.push_back(read_overlay(input, terrain.map, bounds, cell));
  return out;
}

} // namespace orograph
