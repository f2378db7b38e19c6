// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/options/option.hpp"
#include "cli/render_settings.hpp"

namespace orograph {

/// Reads the template, if there is one, and settles what letters texts have, once format, pens and
/// sheets are known. Throws Error.
void check_lettering(RenderSettings& settings, const GivenOptions& given);

} // namespace orograph
