// SPDX-License-Identifier: GPL-3.0-or-later
// From the places that a user names to eye and target in the ground frame.
#pragma once

#include "cli/render_settings.hpp"
#include "dem/terrain.hpp"
#include "view/view_request.hpp"

#include <optional>

namespace orograph {

/// Sets eye, and target or direction of looking, of `request`, as far as the settings give them.
/// What has no height stands on the ground, the eye as high above it as asked for after the ground
/// has been exaggerated by `request.exaggeration`; heights that are given are the file's. A
/// direction counts from true north where the CRS tells it, else from the map's upwards.
///
/// Throws Error, one line that names the option: longitude and latitude where the CRS isn't on the
/// earth, or without a place in it; no ground where a height is needed; longitude and latitude
/// swapped.
/// REQUIRES of a terrain in degrees that its frame lies under the eye (cli/stand_on_earth.hpp).
void place_eye(ViewRequest& request, const RenderSettings& settings, const Terrain& terrain);

/// The eye's place in the terrain's own coordinates, or the target's where no eye is given. Throws
/// the same Errors.
std::optional<Vec2> given_place(const RenderSettings& settings, const Terrain& terrain);

} // namespace orograph
