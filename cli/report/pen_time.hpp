// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/render_settings.hpp"

#include <optional>
#include <vector>

namespace orograph {

/// How many minutes each layer takes: by its pen's own speed, else by that of the settings; none
/// where neither is told. What shows a pen's way takes none of them.
std::vector<std::optional<double>> minutes_by_layer(const Drawing& drawing,
                                                    const RenderSettings& settings);

/// Of all layers; none where one isn't known, or there is none.
std::optional<double> sum_of(const std::vector<std::optional<double>>& minutes);

} // namespace orograph
