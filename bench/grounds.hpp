// SPDX-License-Identifier: GPL-3.0-or-later
// The two terrains that views are measured on, in any size.
#pragma once

#include "bench/scenes.hpp"
#include "data_samples/terrains.hpp"

#include <array>

namespace orograph {

struct Ground {
  const char* name;
  Grid (*made)(int vertices); ///< a side
};

/// The same square in finer cells, smooth at the size of a cell; and more mountains in cells of
/// the same size, as steep from cell to cell as they are at large.
inline constexpr std::array kGrounds{
    Ground{"smooth", [](int n) { return make_terrain(MadeTerrain::fractal_alps, n); }},
    Ground{"rough", fractal_terrain}};

} // namespace orograph
