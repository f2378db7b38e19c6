// SPDX-License-Identifier: GPL-3.0-or-later
// The folder of a sweep before its first view is drawn.
#pragma once

#include "cli/sweep/plan.hpp"
#include "cli/sweep/sweep_settings.hpp"

#include <cstddef>
#include <vector>

namespace orograph {

/// Makes the folder, writes the plan, and tells which views of the shard are still to be drawn.
/// With
/// `--resume` those that are done stay as they are, what an end has left half-written is removed,
/// and rows that can't be read are told of on stderr; with `--overwrite` an older sweep is removed,
/// and nothing else. Throws Error where the folder can't be written to, where it holds another
/// sweep, or this one without `--resume`, and where something else would be overwritten.
std::vector<std::size_t> open_folder(const SweepSettings& settings, const Plan& plan);

/// Makes the folder of a new sweep and writes its plan; another process may do the same just now.
/// Throws Error where the folder can't be written to, and where it holds a file that the sweep
/// would replace, or the plan of another.
void begin_folder(const std::string& out_dir, const Plan& plan);

/// The temporary files of a sweep that was killed. REQUIRES that nobody draws into the folder.
void remove_leftovers(const std::string& out_dir);

} // namespace orograph
