// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a sweep, and its page, from what is kept of its views.
#pragma once

#include "cli/sweep/plan.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace orograph {

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

} // namespace orograph
