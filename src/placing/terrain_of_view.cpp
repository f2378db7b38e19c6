// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/terrain_of_view.hpp"

#include "dem/mesh/keep_within.hpp"
#include "dem/terrain.hpp"
#include "geometry/error.hpp"
#include "placing/terrain_facts.hpp"
#include "placing/view_in_frame.hpp"

#include <utility>

namespace orograph {

std::optional<TerrainData> cut_by_view(const TerrainData& terrain, const ViewSpec& view) {
  if (!view.file || !view.file->cuts() || !has_ground(terrain.surface)) return std::nullopt;
  // Of a view in a file nothing is chosen by the terrain.
  const double exaggeration = terrain.map.earth ? 1 : exaggeration_of(view, {});
  Tin kept = keep_within(terrain.surface, between_planes(*view.file, terrain.map, exaggeration));
  if (kept.triangles.empty())
    throw Error(view.file_name + ": front and back plane leave nothing of the terrain",
                "put them on either side of it");
  TerrainData out{.surface = std::move(kept),
                  .map = terrain.map,
                  .source = terrain.source,
                  .paths = terrain.paths,
                  .notes = terrain.notes,
                  .triangulation = terrain.triangulation,
                  .surface_error_m = terrain.surface_error_m,
                  .is_overview = terrain.is_overview};
  out.notes.push_back("The view's front and back plane cut the terrain: a TIN is left.");
  return out;
}

TerrainOfView::TerrainOfView(TerrainForViews& whole, const ViewSpec& view)
    : whole_(whole.whole()), in_frame_(whole.in_frame_of(view)) {
  cut_ = cut_by_view(uncut(), view);
}

TerrainOfView::TerrainOfView(const TerrainData& whole, const ViewSpec& view,
                             std::shared_ptr<const TerrainFacts> facts)
    : TerrainOfView(*std::make_unique<TerrainForViews>(
                        std::shared_ptr<const TerrainData>(std::shared_ptr<void>(), &whole),
                        std::move(facts)),
                    view) {}

const TerrainFacts* TerrainOfView::facts() const {
  if (level_) return &level_->facts;
  return cut_ ? nullptr : &in_frame_->facts();
}

} // namespace orograph
