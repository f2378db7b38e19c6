// SPDX-License-Identifier: GPL-3.0-or-later
// What `render` says on stderr of how a map was placed.
#pragma once

#include "dem/terrain.hpp"
#include "draw/drawing.hpp"
#include "hidden_lines/counts.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

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

} // namespace orograph
