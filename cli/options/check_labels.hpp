// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/options/option.hpp"
#include "cli/render_settings.hpp"

namespace orograph {

/// Of names and labels, once layers and view are settled.
void check_labels(RenderSettings& settings, const GivenOptions& given);

} // namespace orograph
