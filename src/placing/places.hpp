// SPDX-License-Identifier: GPL-3.0-or-later
// Places as users name them, on the terrain: for the eye, what it looks at, and solids.
#pragma once

#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"
#include "view/view_request.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace orograph {

/// A place, and what gave it: a field of ViewSpec, or a line of a scene file.
struct NamedPlace {
  std::string name; ///< the field in backquotes, or the file's key: "at", "lonlat"
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
Vec2 place_on_map(const NamedPlace& at, const TerrainData& terrain);

/// The ground at a place in these coordinates, in the ground frame, true height; none where there
/// is none.
std::optional<Vec3> ground_at(Vec2 place, const TerrainData& terrain);

/// A named place in the ground frame, true height: that given, or the ground's and
/// `above_ground_m`. Throws Error as well where there is no ground to stand on.
Vec3 place_in_ground_frame(const NamedPlace& at, const TerrainData& terrain, double above_ground_m);

/// Sets eye, and target or direction of looking, of `request`, as far as `view` gives them; the eye
/// on a summit where it asks for one (placing/eye_summit.hpp).
/// What has no height stands on the ground, the eye as high above it as asked for after the ground
/// has been exaggerated by `request.exaggeration`; heights that are given are the file's. A
/// direction counts from true north where the CRS tells it, else from the map's upwards.
///
/// Throws Error, one line that names the field: longitude and latitude where the CRS isn't on the
/// earth, or without a place in it; no ground where a height is needed; longitude and latitude
/// swapped.
/// REQUIRES of a terrain in degrees that its frame lies under the eye
/// (placing/terrain_of_view.hpp).
void place_eye(ViewRequest& request, const ViewSpec& view, const TerrainData& terrain);

/// The eye's place in the terrain's own coordinates, or the target's where no eye is given. Throws
/// the same Errors.
std::optional<Vec2> given_place(const ViewSpec& view, const TerrainData& terrain);

} // namespace orograph
