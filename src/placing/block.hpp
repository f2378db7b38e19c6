// SPDX-License-Identifier: GPL-3.0-or-later
// A terrain as a block: how deep it is (docs/blocks.md).
#pragma once

#include "dem/terrain.hpp"
#include "geometry/blocked_points.hpp"
#include "placing/map_spec.hpp"
#include "profiles/outline.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

/// The height of its base, as heights are in the terrain: metres, not exaggerated. Throws Error
/// where that isn't below all heights, or there is no terrain.
double block_base_m(const TerrainData& terrain, const BlockSpec& spec);

/// The place straight below a vertex, in the ground frame, at a height; `vertex_m` is the vertex
/// there, at `height_m`. On the ellipsoid straight below is so in the frame.
inline Vec3 below_vertex_m(const TerrainData& terrain, Vec3 vertex_m, double height_m,
                           double at_m) {
  const double exaggeration = terrain.map.earth ? terrain.map.earth->exaggeration : 1;
  return {vertex_m.x, vertex_m.y, vertex_m.z - exaggeration * (height_m - at_m)};
}

/// The ends of the border's edges, each once, rising.
std::vector<std::uint32_t> vertices_of(const std::vector<BorderEdge>& border);

/// The foot of the walls, below each of them, in the ground frame.
std::vector<Vec3> block_feet_m(const TerrainData& terrain, const std::vector<BorderEdge>& border,
                               double base_m);

/// Where the base is in the profile frame below the eye of a view.
double base_z_m(double base_m, const View& view, const MapFrame& map);

/// Of an eye over the ground at a height, exaggerated: throws Error where it is in the block.
void check_outside_block(const View& view, double ground_z_m, double base_m, const MapFrame& map);

/// Adds them to what a picture has to show. REQUIRES that both outlive it.
void add_points(const std::vector<Vec3>& feet_m, BlockedPoints& beside);

} // namespace orograph
