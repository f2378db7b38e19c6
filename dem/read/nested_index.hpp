// SPDX-License-Identifier: GPL-3.0-or-later
// The part of an index that has the raster's own heights in larger cells.
#pragma once

#include "dem/levels/nested_cells.hpp"
#include "dem/read/index_blocks.hpp"

#include <cstdint>
#include <istream>
#include <ostream>
#include <vector>

namespace orograph {

/// The sum of each of its blocks: ranges, departures by levels, heights by levels.
void tell_nested(Teller& told, const NestedCells& cells);
void write_nested(std::ostream& file, const NestedCells& cells);

/// The sums that are told, of a raster of this size.
std::vector<std::uint64_t> take_nested(Listener& told, int columns, int rows);
std::uint64_t bytes_of_nested(int columns, int rows, std::uint32_t bytes_of_height);
/// From where the file is. Throws Refused where anything isn't in order.
NestedCells read_nested(std::istream& file, const std::vector<std::uint64_t>& sums, int columns,
                        int rows, std::uint32_t bytes_of_height);

} // namespace orograph
