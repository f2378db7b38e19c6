// SPDX-License-Identifier: GPL-3.0-or-later
// `orograph visible`: which of many points an eye sees.
#pragma once

#include "cli/render_settings.hpp"
#include "map/place_sight.hpp"
#include "write/write_points.hpp"

#include <optional>
#include <string>

namespace orograph {

struct VisibleSettings {
  RenderSettings render; ///< terrain, eye, the skyline's table, overwriting, cores and quiet
  OverlayInput points;
  double target_height_m = 0;
  std::string output = "-";
  PointFormat format = PointFormat::csv;
};

/// What the tables call it.
const char* name_of(PlaceState state);

/// Reads terrain and points, and writes a row for each point, with its attributes and what the eye
/// sees of it; says on stderr how many are seen. Throws Error.
void visible(const VisibleSettings& settings);

} // namespace orograph
