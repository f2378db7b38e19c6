// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of one coordinate: a mesh, a graticule of meridians and parallels, a grid of eastings and
// northings.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"
#include "profiles/isolines.hpp"
#include "view/view.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Lines of one coordinate at equal steps.
struct CoordinateLines {
  std::string coordinate; ///< its name
  VertexValues values;
  std::vector<double> levels; ///< between the least and the greatest of the values, rounded as they
  std::vector<double> exact;  ///< the levels before they were rounded
};

// Each gives the lines of both coordinates. What comes back refers to the terrain and the view.

/// Throws Error where there would be more than 10,000 lines.
std::vector<CoordinateLines> mesh_lines(const TerrainData& terrain, const View& view,
                                        const MeshSpec& spec);

/// On WGS 84; of a terrain in degrees as its CRS counts them. Longitudes beyond 180 degrees go on
/// as the terrain has them. Between places some 16 cells apart they are taken to be linear: on the
/// earth within a millionth of the distance. Throws Error where the CRS isn't on the earth, or
/// there would be more than 10,000 lines.
std::vector<CoordinateLines> graticule_lines(const TerrainData& terrain,
                                             std::optional<double> step_deg);

/// In the terrain's CRS. Throws Error where that counts in degrees, or there would be more than
/// 10,000 lines.
std::vector<CoordinateLines> map_grid_lines(const TerrainData& terrain,
                                            std::optional<double> step_m);

} // namespace orograph
