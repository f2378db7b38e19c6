// SPDX-License-Identifier: GPL-3.0-or-later
// The skyline all round as a table.
#pragma once

#include "cli/render_settings.hpp"
#include "map/place_sight.hpp"

#include <string>

namespace orograph {

/// CSV: azimuth, altitude, distance, longitude and latitude, a row for each direction; what isn't
/// known is empty, as all but the azimuth is where there is no ground.
std::string skyline_csv(const Skyline& skyline);

/// Writes it where `settings` say, whole or not at all. Throws Error.
void write_skyline(const Skyline& skyline, const RenderSettings& settings);

/// Says where the most distant ground is that is seen, and how many directions end with the
/// terrain.
void tell_skyline(const Skyline& skyline, const RenderSettings& settings);

} // namespace orograph
