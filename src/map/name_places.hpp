// SPDX-License-Identifier: GPL-3.0-or-later
// Names and labels on a map: from places to texts, and lines that make room for them.
#pragma once

#include "dem/overlay.hpp"
#include "dem/terrain.hpp"
#include "draw/drawing.hpp"
#include "map/name_facts.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

#include <optional>

#include "lettering/lettering.hpp"
#include "naming/line_labels.hpp"

namespace orograph {

/// What `spec` asks for with room on its page for the names of an overlay, or for the labels of
/// graticule and grid, where there are any: above each strip of a panorama, or around a map.
/// Itself where nothing of the kind is asked for. Throws Error as `place_names` does.
MapSpec with_room_for_names(const MapSpec& spec, const Overlay* names);

/// Puts the names of `placed.names`, and the labels of `lines`, on a drawing whose lines are all
/// there: layers of leaders and labels are added to it, behind the others, and lines of the terrain
/// are broken beneath texts. Returns what became of the names; none where there are none. A name
/// that is no more than 0.2 mm under the horizon is seen. Throws Error as `place_names` does, and
/// where a terrain in degrees is cut by the view's planes.
std::optional<NamesFacts> name_places(const TerrainData& terrain, const PlacedView& placed,
                                      const MapSpec& spec, const LinesToLabel& lines,
                                      Lettering& lettering, Drawing& drawing);

} // namespace orograph
