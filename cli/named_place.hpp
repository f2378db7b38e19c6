// SPDX-License-Identifier: GPL-3.0-or-later
// A place as a user gives it, on the terrain.
#pragma once

#include "cli/given_place.hpp"
#include "dem/terrain.hpp"

#include <cstddef>
#include <string>

namespace orograph {

/// A place, and what gave it: an option, or a line of a scene file.
struct NamedPlace {
  std::string option; ///< or the file's key: "at", "lonlat"
  GivenPlace place;
  bool lonlat = false;
  std::string in_file = {}; ///< "scene.toml, line 12: ", of a scene file

  std::string text() const;        ///< what it is, for messages
  std::string with_height() const; ///< how to give a height as well
  std::string on_map() const;      ///< how to give it in the terrain's own coordinates
  std::string turned() const;      ///< with its two numbers the other way round
};

/// In the terrain's own coordinates; in degrees a longitude of the terrain's own turn. Throws Error
/// where longitude and latitude aren't known, are swapped, beyond a pole, or far from the terrain.
Vec2 place_on_map(const NamedPlace& at, const Terrain& terrain);

/// The same in the ground frame, true height: that given, or the ground's and `above_ground_m`.
/// Throws Error as well where there is no ground to stand on.
Vec3 place_in_ground_frame(const NamedPlace& at, const Terrain& terrain, double above_ground_m);

} // namespace orograph
