// SPDX-License-Identifier: GPL-3.0-or-later
// Eyes along a line in a vector file.
#pragma once

#include "dem/terrain.hpp"
#include "geometry/angle.hpp"
#include "placing/map_spec.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

struct PathEye {
  GivenPlace place; ///< in the terrain's map coordinates
  Angle look;       ///< where the path leads, as `ViewSpec::look_azimuth`
};

/// The line's vertices, or places every `step_m` along it from its first vertex on, as far as it
/// goes: along the earth where the terrain is at a place of it, else on the plane. Heights, if it
/// has any, go along between the vertices. Throws Error where the file holds no line or several,
/// where one is too short, and where its places are none in the terrain's CRS.
std::vector<PathEye> read_eye_path(const std::string& path, std::optional<double> step_m,
                                   const MapFrame& map, bool allow_network = false);

} // namespace orograph
