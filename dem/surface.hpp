// SPDX-License-Identifier: GPL-3.0-or-later
// The two kinds of terrain surface.
#pragma once

#include "dem/grid.hpp"
#include "dem/tin.hpp"

#include <variant>

namespace orograph {

using Surface = std::variant<Grid, Tin>;

} // namespace orograph
