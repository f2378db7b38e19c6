// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph sweep`: many views of one terrain; `orograph merge`: their tables (docs/sweeps.md).
#pragma once

#include "cli/sweep/sweep_settings.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Reads the terrain once and draws every view of the sweep, or of its shard, into OUT_DIR; of a
/// whole sweep the tables and the page as well. Drawings and tables are the same, byte for byte,
/// for any number of threads, shards and processes, but for the tables' seconds. Throws Error where
/// views have failed, after all else is done, and where something can't be written: what is done by
/// then is kept.
void sweep(const SweepSettings& settings);

struct MergeSettings {
  std::string out_dir;
  std::vector<std::string> shard_dirs; ///< what they hold of the sweep is copied to OUT_DIR
  bool quiet = false;
};

/// Writes the tables and the page of the sweep in OUT_DIR. Throws Error where views are missing or
/// have failed, after that, and where a folder holds no sweep or another one.
void merge(const MergeSettings& settings);

} // namespace orograph
