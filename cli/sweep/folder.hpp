// SPDX-License-Identifier: GPL-3.0-or-later
// The folder of a sweep: begun or gone on with, how it stands, its tables and its page.
#pragma once

#include "cli/sweep/journal.hpp"
#include "cli/sweep/sweep.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace orograph {

/// Makes the folder, writes the plan, and tells which views of the shard are still to be drawn.
/// With `--resume` those that are done stay as they are, what an end has left half-written is
/// removed, and rows that can't be read are told of on stderr; with `--overwrite` an older sweep is
/// removed, and nothing else. Throws Error where the folder can't be written to, where it holds
/// another sweep, or this one without `--resume`, and where something else would be overwritten.
std::vector<std::size_t> open_folder(const SweepSettings& settings, const Plan& plan);

/// Makes the folder of a new sweep and writes its plan; another process may do the same just now.
/// Throws Error where the folder can't be written to, and where it holds a file that the sweep
/// would replace, or the plan of another.
void begin_folder(const std::string& out_dir, const Plan& plan);

/// The temporary files of a sweep that was killed. REQUIRES that nobody draws into the folder.
void remove_leftovers(const std::string& out_dir);

struct SweepState {
  std::vector<std::size_t> missing; ///< views without a row
  std::vector<std::size_t> failed;  ///< views with an error instead of a drawing
  std::vector<std::string> corrupt; ///< rows that can't be read; their views are missing
};

/// A view is done where its row and its drawing are there.
SweepState state_of(const std::string& out_dir, const Plan& plan);

/// Writes sweep.csv, sweep.json and index.html, of all rows that there are; what can't be read is
/// left out. Tells what it found. Throws Error where they can't be written.
SweepState write_tables(const std::string& out_dir, const Plan& plan);

/// Throws Error where a symbolic link stands for a file of the sweep or for its folder of rows: it
/// would lead out of the sweep's folder.
void refuse_links(const std::string& out_dir, const Plan& plan);

/// Tells on stderr, unless quiet, how many views there are and where to look. Throws Error where
/// views of the shard have failed or are missing.
void check_done(const SweepState& state, const std::string& out_dir, const Plan& plan,
                const Shard& shard, bool quiet);

} // namespace orograph
