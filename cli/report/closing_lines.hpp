// SPDX-License-Identifier: GPL-3.0-or-later
// What `orograph render` says when it is done.
#pragma once

#include "cli/render_settings.hpp"
#include "map/map_facts.hpp"
#include "placing/placed_view.hpp"

#include <span>
#include <string>
#include <vector>

namespace orograph {

/// A line with strokes, ink, view, exaggeration and seconds; before it one where profiles can't
/// show relief, since they are seen from straight above. Strokes, ink and minutes are those of the
/// sheets, where there are any. REQUIRES a map of this placed view.
std::vector<std::string> closing_lines(const Map& map, std::span<const Drawing> sheets,
                                       const PlacedView& placed, const RenderSettings& settings,
                                       double seconds);

} // namespace orograph
