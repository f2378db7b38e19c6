// SPDX-License-Identifier: GPL-3.0-or-later
// The file beside a raster that holds it in larger cells, so that a large one is read once and not
// for each map.
#pragma once

#include "dem/levels/larger_cells.hpp"
#include "dem/read/open_rasters.hpp"
#include "dem/read/raster_heights.hpp"
#include "dem/read/read_options.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct IndexedLevel {
  LargerCells cells;
  int columns = 0, rows = 0;
  ReadHeights heights;
};

/// Where the index of these rasters is: beside the first, as NAME.levels.
std::string index_path(const std::vector<std::string>& paths);

/// All that decides a terrain's heights, as text: names, sizes and times of the files (a VRT's
/// sources are among them), and how they are read. None where that can't be told, as of files that
/// aren't on a disk.
std::optional<std::string> state_of(const RasterSet& set, const ReadOptions& options);

/// Whether a file there is an index, of whatever state and version.
bool is_index(const std::string& path);

/// REQUIRES nested cells with the first level. Throws Error where the file can't be written whole;
/// it is then left to who named it.
void write_index(const std::string& path, const std::string& state,
                 const std::vector<IndexedLevel>& levels);

struct IndexFound {
  std::optional<IndexedLevel> level;
  std::string why_not; ///< why an index that is there isn't used, as a sentence; empty: none there
};

/// The level of so many cells to one for a terrain of this state, with its nested cells or without.
/// An index is believed only where all of it that is read is in order: its state, its sizes, and
/// sums over its parts. None and no reason where there is no index, or this level isn't in it.
/// Never throws because of what is in the file.
IndexFound find_level(const std::string& path, const std::string& state, const RasterSet& set,
                      int step, bool with_nested);

/// What is told of an index: the steps of its levels, or why `find_level` wouldn't use it; neither
/// where there is none. Its heights aren't looked at.
struct IndexState {
  std::vector<int> steps;
  std::string why_not;
};
IndexState look_at_index(const std::string& path, const std::string& state, const RasterSet& set);

} // namespace orograph
