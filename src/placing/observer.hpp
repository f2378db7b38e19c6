// SPDX-License-Identifier: GPL-3.0-or-later
// An eye that looks all round: without a picture, its window and its page.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"
#include "placing/placed_view.hpp"
#include "view/view.hpp"

#include <optional>

namespace orograph {

struct Observer {
  /// In perspective, forward to the frame's north: u is east and v north of the eye. It has no
  /// window.
  View view;
  bool curvature = false; ///< whether ground is drawn lower, or refraction lifts it
};

/// Of a view's eye, its height above the ground, curvature, refraction and exaggeration (true
/// heights unless told otherwise). The earth's curvature is there unless it is off, or nothing is
/// known of the terrain's place. Throws Error as `place_eye` does, and where the eye is under the
/// ground. REQUIRES an eye, and of a terrain in degrees that its frame lies below it, with heights
/// exaggerated (placing/terrain_of_view.hpp).
Observer observer_of(const ViewSpec& view, const TerrainData& terrain);

/// That of a picture, whose curvature is the picture's. REQUIRES a perspective view.
Observer observer_of(const PlacedView& placed, const MapFrame& map);

/// Of an eye at a height above the ground at its place, both exaggerated. Throws Error where it is
/// under it.
void check_above_ground(const View& view, double ground_z_m, const MapFrame& map);

} // namespace orograph
