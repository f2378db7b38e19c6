// SPDX-License-Identifier: GPL-3.0-or-later
// How a sweep came out.
#pragma once

#include "cli/sweep/plan.hpp"
#include "cli/sweep/sweep_settings.hpp"
#include "cli/sweep/tables.hpp"

#include <string>

namespace orograph {

/// Tells on stderr, unless quiet, how many views there are and where to look. Throws Error where
/// views of the shard have failed or are missing.
void check_done(const SweepState& state, const std::string& out_dir, const Plan& plan,
                const Shard& shard, bool quiet);

} // namespace orograph
