// SPDX-License-Identifier: GPL-3.0-or-later
// The two kinds of terrain surface.
#pragma once

#include "dem/grid.hpp"
#include "dem/tin.hpp"

#include <variant>

namespace orograph {

using Surface = std::variant<Grid, Tin>;

/// A scene may stand on nothing: a TIN without triangles.
inline bool has_ground(const Surface& surface) {
  const Tin* tin = std::get_if<Tin>(&surface);
  return !tin || !tin->triangles.empty();
}

} // namespace orograph
