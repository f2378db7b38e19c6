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

Ground& Grounds::of(const MapSpec& spec) {
  return ground_of(bare_ ? bare_ : terrains_.of(spec));
}

Ground& Grounds::before_views() {
  return ground_of(bare_ ? bare_ : terrains_.before_views(settings_.map));
}

Ground& Grounds::ground_of(std::shared_ptr<const TerrainData> terrain) {
  const std::lock_guard lock(mutex_);
  const auto known = by_terrain_.find(terrain.get());
  if (known != by_terrain_.end()) return known->second;
  std::vector<Overlay> overlays = read_overlays(settings_.overlays, *terrain), names;
  if (!settings_.labels.path.empty()) names = read_overlays({&settings_.labels, 1}, *terrain);
  std::optional<TerrainFacts> facts;
  if (!terrain->map.earth) facts = facts_of(*terrain);
  Ground& ground = by_terrain_[terrain.get()];
  ground.overlays = std::move(overlays);
  ground.names = std::move(names);
  ground.facts = std::move(facts);
  ground.terrain = std::move(terrain);
  return ground;
}

} // namespace orograph
