// SPDX-License-Identifier: GPL-3.0-or-later
// Rasters that are read in bands of rows and kept in larger cells only.
#pragma once

#include "dem/read/level_index.hpp"
#include "dem/read/open_rasters.hpp"
#include "dem/read/raster_heights.hpp"
#include "dem/read/read_options.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace orograph {

/// The step that leaves at least so many cells along the shorter side: 1, 2, 4, 8 ...
int step_leaving(int columns, int rows, int least_cells);

/// Memory that a level of so many cells to one takes while it is made, in bytes; with nested cells
/// as well or without.
std::uint64_t bytes_in_bands(const RasterSet& set, int step, bool with_nested);

/// Gives the set's grid, which has no heights yet, larger cells, `step` of its own to one, from the
/// index if there is a good one, else in bands; and its terrain what is known of them. Adds what is
/// noticed of the index to `doubts`. REQUIRES `options.large`. Cost without an index: that of
/// reading, and some 5 ns a height on all cores; of nested cells another 6.
void read_larger_cells(RasterSet& set, int step, const ReadOptions& options,
                       HeightDifferences& differences, std::vector<std::string>& doubts,
                       const std::function<void(double)>& progress);

struct RasterIndex {
  std::string state;
  std::vector<IndexedLevel> levels; ///< of 4, 8, 16 ... cells to one; the first with nested cells
  std::vector<std::string> doubts;  ///< as a terrain's, about what the files name
};

/// The index of rasters, in one pass over them. Throws Error as `read_rasters` does, where only a
/// part of them is asked for, where they are too small for one, and where their state can't be
/// told.
RasterIndex index_of(const std::vector<std::string>& paths, const ReadOptions& options,
                     const std::function<void(double)>& progress = {});

/// What is told of these rasters' index. Nothing where they aren't rasters, or aren't on a disk.
IndexState index_state(const std::vector<std::string>& paths, const ReadOptions& options);

} // namespace orograph
