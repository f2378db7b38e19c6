// SPDX-License-Identifier: GPL-3.0-or-later
// What stands around a picture.
#pragma once

#include "dem/terrain.hpp"
#include "map/map_facts.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"

#include <vector>

#include "lettering/lettering.hpp"

namespace orograph {

/// The layer of furniture that the spec asks for, with its texts set, around a picture that leaves
/// the room of `page_with_room`. `facts` get the pieces: no box overlaps another, nor the picture's
/// window, which is first among them.
Layer draw_furniture(const TerrainData& terrain, const PlacedView& placed, const MapSpec& spec,
                     Lettering& lettering, std::vector<FurnitureFacts>& facts);

} // namespace orograph
