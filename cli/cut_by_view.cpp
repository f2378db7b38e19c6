// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cut_by_view.hpp"

#include "cli/scene.hpp"
#include "cli/scene_view.hpp"
#include "dem/extent.hpp"
#include "dem/mesh/keep_within.hpp"
#include "geometry/error.hpp"

#include <utility>

namespace orograph {

std::optional<Terrain> cut_by_view(const Terrain& terrain, const RenderSettings& settings) {
  if (!settings.view || !settings.view->cuts() || !has_ground(terrain.surface)) return std::nullopt;
  // Of a view in a file nothing is chosen by the terrain.
  const double exaggeration = terrain.map.earth ? 1 : exaggeration_of(settings, {});
  Tin kept =
      keep_within(terrain.surface, between_planes(*settings.view, terrain.map, exaggeration));
  if (kept.triangles.empty())
    throw Error(settings.view_file + ": front and back plane leave nothing of the terrain",
                "put them on either side of it");
  Terrain out{.surface = std::move(kept),
              .map = terrain.map,
              .source = terrain.source,
              .paths = terrain.paths,
              .notes = terrain.notes,
              .triangulation = terrain.triangulation,
              .surface_error_m = terrain.surface_error_m};
  out.notes.push_back("The view's front and back plane cut the terrain: a TIN is left.");
  return out;
}

} // namespace orograph
