// SPDX-License-Identifier: GPL-3.0-or-later
// What the strips of X have found, each with numbers of its own for lines that it has found itself,
// as one.
#pragma once

#include "hidden_lines/lattice_strip.hpp"
#include "hidden_lines/sector_in_work.hpp"

#include <memory>
#include <vector>

namespace orograph {

/// Lines found get numbers from `listed` on, in the order of their edges; those of which nothing is
/// visible get none. Cost: a sort of what is visible.
SectorParts parts_by_edge(const std::vector<std::unique_ptr<LatticeStrip>>& strips,
                          std::size_t listed);

} // namespace orograph
