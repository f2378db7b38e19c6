// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/terrain_of_view.hpp"

#include "cli/cut_by_view.hpp"
#include "cli/stand_on_earth.hpp"

namespace orograph {

TerrainOfView::TerrainOfView(const Terrain& whole, const RenderSettings& settings) : whole_(whole) {
  if (whole.map.earth) {
    on_earth_ = whole;
    stand_on_earth(*on_earth_, settings);
  }
  cut_ = cut_by_view(uncut(), settings);
}

} // namespace orograph
