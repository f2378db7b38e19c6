// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of a pen and of what moves it.
#pragma once

#include "cli/options/option.hpp"
#include "cli/render_settings.hpp"

namespace orograph {

/// Settles the order of strokes, device and pens, as the format wants them, how light shows, and
/// the page of several sheets. Throws UsageError where what is asked has no meaning in the format,
/// and what `read_device` and `read_pens` throw. REQUIRES a format.
void check_plotting(RenderSettings& settings, const GivenOptions& given);

} // namespace orograph
