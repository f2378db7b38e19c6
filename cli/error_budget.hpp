// SPDX-License-Identifier: GPL-3.0-or-later
// How far a drawn line can be from where it should be, by cause (docs/how-it-works.md).
#pragma once

#include "cli/render_settings.hpp"
#include "cli/report.hpp"
#include "cli/scene.hpp"

namespace orograph {

/// Each cause's bound in mm on paper.
ErrorBudget error_budget(const Terrain& terrain, const Scene& scene,
                         const RenderSettings& settings);

} // namespace orograph
