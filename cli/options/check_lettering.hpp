// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/render_settings.hpp"

namespace orograph {

/// Settles what letters texts have, once format, pens and sheets are known.
void check_lettering(RenderSettings& settings);

} // namespace orograph
