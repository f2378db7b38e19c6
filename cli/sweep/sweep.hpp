// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph sweep`: many views of one terrain; `orograph merge`: their tables (docs/sweeps.md).
#pragma once

#include "cli/render_settings.hpp"
#include "cli/sweep/parameter.hpp"
#include "placing/view_file.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// Every `count`th view, from the `index`th (1 to count) on.
struct Shard {
  int index = 1, count = 1;

  bool holds(std::size_t view) const {
    return view % static_cast<std::size_t>(count) == static_cast<std::size_t>(index - 1);
  }
  /// How many of so many views it holds.
  std::size_t size(std::size_t views) const {
    return (views + static_cast<std::size_t>(count - index)) / static_cast<std::size_t>(count);
  }
};

struct SweepSettings {
  RenderSettings render; ///< what all views share; `output` is unused
  std::string out_dir;
  std::vector<Axis> axes;           ///< in the order of Parameter; without those of the next two
  std::string eye_path;             ///< a vector file with a line; empty: none
  std::optional<double> eye_step_m; ///< none: at the line's own vertices
  std::string views_file;
  std::vector<NamedView> views; ///< what it holds
  bool zipped = false;          ///< the axes go together, instead of being crossed
  std::string name_template;    ///< empty: by what varies

  int jobs = 0; ///< 0: one for each core; under MPI one
  Shard shard;
  bool resume = false;
  bool many = false;   ///< yes, more than kManyViews
  bool seconds = true; ///< the tables' only column that differs from run to run

  /// Those that decide what is drawn, by name with their values as given.
  std::map<std::string, std::vector<std::string>> options;
};

/// More than these are a mistake, unless said to be none.
constexpr double kManyViews = 10000;

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
