// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/terrain_of_view.hpp"

#include "cli/cut_by_view.hpp"
#include "cli/stand_on_earth.hpp"

#include <utility>

namespace orograph {

TerrainOfView::TerrainOfView(const Terrain& whole, const RenderSettings& settings) : whole_(whole) {
  if (whole.map.earth) {
    own_ = whole;
    stand_on_earth(*own_, settings);
  }
  if (std::optional<Terrain> cut = cut_by_view(**this, settings)) own_ = std::move(cut);
}

} // namespace orograph
