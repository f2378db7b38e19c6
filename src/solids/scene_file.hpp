// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene file says, its graph walked: solids, and where instances of them stand.
#pragma once

#include "solids/solid.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// Where a part of the scene is put. Its own frame goes there: x east, y north, z up.
struct ScenePlace {
  std::string part;             ///< its name
  double x = 0, y = 0;          ///< map coordinates of the terrain, or longitude and latitude
  bool lonlat = false;          ///< the second
  std::optional<double> height; ///< in the unit of the terrain's heights; none: on the ground
  std::size_t line = 0;         ///< of the file
};

/// A place p becomes p.x * x + p.y * y + p.z * z + origin.
struct AffineMap {
  Vec3 x, y, z; ///< what the unit vectors become
  Vec3 origin;  ///< what the origin becomes
  bool operator==(const AffineMap&) const = default;
};

/// One path through the scene graph, from a place to a solid. A negative determinant mirrors it.
struct SolidInstance {
  std::size_t place = 0, solid = 0;
  AffineMap to_place; ///< from the solid's own frame to the place's, metres; not singular
};

struct SceneFile {
  std::string path;
  std::vector<std::string> shape_files; ///< paths of those that its polyhedra are read from
  std::vector<Solid> solids;            ///< one copy of each
  std::vector<ScenePlace> places;       ///< in the file's order
  std::vector<SolidInstance> instances; ///< by place, then as the walk meets them
};

} // namespace orograph
