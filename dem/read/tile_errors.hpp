// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of rasters that can't be joined.
#pragma once

#include "dem/read/join_tiles.hpp"

#include <optional>
#include <vector>

namespace orograph {

/// Throws Error: the tile's vertices aren't those of the base's lattice, with the command that
/// brings them there. `same_steps`: only its place doesn't fit.
[[noreturn]] void refuse_lattices(const Tile& base, const Tile& tile, bool same_steps,
                                  std::optional<int> overview);

/// Throws Error: some tiles touch none of those that are `together`.
[[noreturn]] void refuse_apart(const std::vector<Tile>& tiles, const std::vector<bool>& together);

} // namespace orograph
