// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cut_by_view.hpp"

#include "cli/scene.hpp"
#include "cli/scene_view.hpp"
#include "dem/extent.hpp"
#include "dem/mesh/keep_within.hpp"
#include "geometry/error.hpp"

#include <utility>

namespace orograph {

void cut_by_view(Terrain& terrain, const RenderSettings& settings) {
  if (!settings.view || !settings.view->cuts()) return;
  // Of a view in a file nothing is chosen by the terrain.
  const double exaggeration = terrain.map.earth ? 1 : exaggeration_of(settings, {});
  Tin kept =
      keep_within(terrain.surface, between_planes(*settings.view, terrain.map, exaggeration));
  if (kept.triangles.empty())
    throw Error(settings.view_file + ": front and back plane leave nothing of the terrain",
                "put them on either side of it");
  terrain.surface = std::move(kept);
  terrain.notes.push_back("The view's front and back plane cut the terrain: a TIN is left.");
}

} // namespace orograph
