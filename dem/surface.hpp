// SPDX-License-Identifier: GPL-3.0-or-later
// The two kinds of terrain surface.
#pragma once

#include "dem/grid.hpp"
#include "dem/tin.hpp"

#include <cstddef>
#include <variant>

namespace orograph {

using Surface = std::variant<Grid, Tin>;

/// A scene may stand on nothing: a TIN without triangles.
inline bool has_ground(const Surface& surface) {
  const Tin* tin = std::get_if<Tin>(&surface);
  return !tin || !tin->triangles.empty();
}

/// Numbers of vertices are below it, whether they have a height or not.
inline std::size_t vertex_count(const Surface& surface) {
  const Grid* grid = std::get_if<Grid>(&surface);
  return grid ? grid->size() : std::get<Tin>(surface).vertices_m.size();
}

} // namespace orograph
