// SPDX-License-Identifier: GPL-3.0-or-later
// What of a panorama's options doesn't go together.
#pragma once

#include "cli/options/option.hpp"
#include "cli/render_settings.hpp"

namespace orograph {

/// Throws UsageError where options of panoramas are given for another projection, or the other way
/// round, and where a panorama has no eye.
void check_panorama(const RenderSettings& settings, const GivenOptions& given);

} // namespace orograph
