// SPDX-License-Identifier: GPL-3.0-or-later
// Overlays from vector files.
#pragma once

#include "dem/overlay.hpp"
#include "dem/read/overlay_input.hpp"
#include "dem/terrain.hpp"
#include "geometry/box.hpp"

namespace orograph {

/// What of a layer may be on a terrain: points, lines, and polygons as their rings, of any
/// geometry that OGR has, with all fields as attributes; of CSV points by columns lon and lat (WGS
/// 84), or x and y, easting and northing (the terrain's), or the like. Brought into the terrain's
/// CRS, with places between wherever a straight line bends by more than a tenth of a cell. Where
/// one of the two has no CRS, coordinates are taken as they are, with a note.
///
/// Throws Error: no such file, layer or field, a condition that isn't one, CRSs without a way
/// between them, geometries without places, and where nothing of the layer is over the terrain. Of
/// several layers the only one that isn't empty is taken, as of GPX. Memory: 16 bytes a place;
/// features elsewhere aren't read. `map`: the terrain's, `bounds`: its box in map coordinates,
/// `cell`: the size of one in these.
Overlay read_overlay(const OverlayInput& input, const MapFrame& map, const Box2& bounds,
                     double cell);

} // namespace orograph
