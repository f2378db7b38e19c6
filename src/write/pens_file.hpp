// SPDX-License-Identifier: GPL-3.0-or-later
// Pens as a file tells them.
#pragma once

#include "draw/assign_pens.hpp"
#include "geometry/api.hpp"
#include "write/device.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// TOML with a table [[pen]] for each pen: width in mm; number (without it one more than the pen
/// before has), name, colour as `colour_of` reads it (black), speed in mm/s, height in percent,
/// pause, layers, field with values, and dash, which may be left out (docs/plotters.md). `layers`
/// are those that there are. Throws Error of one line that begins with the file's name, and line
/// where there is one, for a file that can't be read, isn't TOML or has no pen, for other keys,
/// values that make no pen, unknown layers, a number that is given twice, and, where there is a
/// device, a pen that it hasn't or can't wait for.
OROGRAPH_API std::vector<PenOfLayers> read_pens(const std::string& path,
                                                std::span<const std::string_view> layers,
                                                const Device* device = nullptr);

} // namespace orograph
