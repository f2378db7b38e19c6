// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/grounds.hpp"

#include "cli/render.hpp"
#include "placing/read_overlays.hpp"

#include <utility>

namespace orograph {

Grounds::Grounds(const RenderSettings& settings)
    : settings_(settings), terrains_(settings.inputs, settings.reading, settings.solids.get()) {
  if (stands_on_nothing(settings))
    bare_ = std::make_shared<const TerrainData>(read_ground(settings));
}

std::shared_ptr<Ground> Grounds::of(const MapSpec& spec) {
  return ground_of(bare_ ? bare_ : terrains_.of(spec));
}

std::shared_ptr<Ground> Grounds::before_views() {
  return ground_of(bare_ ? bare_ : terrains_.before_views(settings_.map));
}

std::shared_ptr<Ground> Grounds::ground_of(std::shared_ptr<const TerrainData> terrain) {
  const std::lock_guard lock(mutex_);
  if (const auto known = kept_.find(terrain.get()); known != kept_.end()) return known->second;
  auto ground = std::make_shared<Ground>();
  ground->overlays = read_overlays(settings_.overlays, *terrain);
  if (!settings_.labels.path.empty())
    ground->names = read_overlays({&settings_.labels, 1}, *terrain);
  if (!terrain->map.earth) ground->facts = facts_of(*terrain);
  ground->terrain = std::move(terrain);
  const auto& larger = ground->terrain->larger_cells;
  const bool is_of_one_eye = larger && !larger->parts.empty();
  if (!is_of_one_eye) kept_.emplace(ground->terrain.get(), ground);
  return ground;
}

} // namespace orograph
