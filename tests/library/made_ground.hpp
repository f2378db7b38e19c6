// SPDX-License-Identifier: GPL-3.0-or-later
// Terrains in memory and views of them, for tests of the library's face.
#pragma once

#include "orograph.hpp"
#include "tests/support/slow_build.hpp"

#include <memory>
#include <string>
#include <vector>

namespace orograph {

/// Vertices a side: as many as asked for; in slow builds, which are there for the sanitizers, a
/// third: their faults show on any ground.
inline int made_side(int side) {
  return is_slow_build() ? side / 3 : side;
}

using OwnedHeights = std::shared_ptr<std::vector<float>>;

/// Mountains as steep from cell to cell as they are at large: `side` by `side` heights, so that
/// each stage has much to do.
OwnedHeights rough_heights(int side);

/// A square of them in UTM, with cells of 30 m, that lies as a Grid has it and has their owner.
GridInput borrowed(const OwnedHeights& heights, int side);

/// A surveyed hill: the triangles of a small grid of heights.
TinInput hill_of_triangles(int side);

/// The place in the middle of `borrowed`, at which an eye can stand.
GivenPlace middle(int side);

/// Views that differ in all that a stage asks for: projections, eyes in the landscape, sectors
/// ahead and behind, occluders, layers, ground points, checks.
std::vector<MapSpec> many_specs(int side);
/// Of them as many as `last_seed` says.
std::vector<MapSpec> enough_specs(int side);

/// The bytes of the file that `write_drawing` makes: SVG, or GeoJSON of a drawing that is tied to
/// the ground.
std::string bytes_of(const Drawing& drawing);

/// Of a drawing of `session`.
std::string drawn_bytes(const Session& session, const MapSpec& spec, const Control& control = {});

} // namespace orograph
