// SPDX-License-Identifier: GPL-3.0-or-later
// What `render` says on stderr of how a map was placed, and when it is done.
#pragma once

#include "cli/render_settings.hpp"
#include "dem/terrain.hpp"
#include "draw/drawing.hpp"
#include "hidden_lines/counts.hpp"
#include "map/map_facts.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

#include <span>
#include <string>
#include <vector>

namespace orograph {

/// A line for each thing that was chosen for the user, and for what may be wrong with the eye, each
/// with the option that says otherwise.
void tell_placing(const PlacedView& placed, const ViewSpec& view);

/// Says to where the eye went, if it is to stand on a summit.
void tell_eye_move(const ViewSpec& view, const TerrainData& terrain);

/// What their reader assumed, and what GDAL warned of.
void tell_notes(const std::vector<Overlay>& overlays);

/// That, and what of what is to be draped isn't on the terrain.
void tell_overlays(const std::vector<Overlay>& overlays, const Counts& counts);

/// Says so if none of the heights that contours are asked for at is one of the ground's.
void tell_contours(const Style& style, const TerrainData& terrain, const Drawing& drawing);

/// Says what leaves the terrain's place, CRS or heights in doubt.
void tell_doubts(const TerrainData& terrain);

/// A line with strokes, ink, view, exaggeration and seconds; before it one where profiles can't
/// show relief, since they are seen from straight above. Strokes, ink and minutes are those of the
/// sheets, where there are any. REQUIRES a map of this placed view.
std::vector<std::string> closing_lines(const Map& map, std::span<const Drawing> sheets,
                                       const PlacedView& placed, const RenderSettings& settings,
                                       double seconds);

} // namespace orograph
