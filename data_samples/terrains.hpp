// SPDX-License-Identifier: GPL-3.0-or-later
// Made terrains: heights as pure functions of the place, the same on every machine.
#pragma once

#include "dem/grid.hpp"
#include "geometry/vec.hpp"

#include <array>
#include <string>

namespace orograph {

enum class MadeTerrain {
  cone,             ///< one summit on a plain of height 0, straight slopes
  plateau,          ///< a level table with steep, gullied sides above a gently sloping plain
  saddle,           ///< a pass: rises to west and east, falls to north and south
  ridge_and_valley, ///< long parallel ridges, bent and cut by gaps
  fractal_alps,     ///< high mountains with eroded slopes
  islands           ///< an archipelago in a flat sea of height exactly 0
};

inline constexpr std::array all_made_terrains{
    MadeTerrain::cone,         MadeTerrain::plateau,
    MadeTerrain::saddle,       MadeTerrain::ridge_and_valley,
    MadeTerrain::fractal_alps, MadeTerrain::islands};

/// As in the file names, such as "fractal_alps".
std::string name_of(MadeTerrain terrain);

/// Side of the square that it covers, metres.
double side_m(MadeTerrain terrain);

/// Height in metres at a place `at_m`, metres east and north of the square's south-west corner
/// (defined beyond the square too). Made with integers, + - * / and square roots only, so that it
/// is the same to the last bit on every machine. Costs up to 2 microseconds.
double made_height_m(MadeTerrain terrain, Vec2 at_m);

/// The whole square with `vertices` by `vertices` heights, in float; position (0, 0) is the
/// square's south-west corner. REQUIRES vertices >= 2.
Grid make_terrain(MadeTerrain terrain, int vertices);

} // namespace orograph
