// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/grounds.hpp"

#include "dem/read/read_terrain.hpp"
#include "placing/read_overlays.hpp"

#include <utility>

namespace orograph {

bool is_scene(const std::string& input) {
  return input.ends_with(".toml") || input.ends_with(".TOML");
}

bool stands_on_nothing(const GroundFiles& files) {
  return files.inputs.size() == 1 && is_scene(files.inputs.front());
}

TerrainData read_ground(const GroundFiles& files) {
  if (!stands_on_nothing(files)) return read_terrain(files.inputs, files.reading);
  TerrainData bare;
  bare.surface = Tin{};
  bare.map.crs_name = "none";
  bare.source = files.inputs.front();
  bare.paths = files.inputs;
  return bare;
}

Grounds::Grounds(const GroundFiles& files)
    : files_(files), terrains_(files.inputs, files.reading, files.solids.get()) {
  if (stands_on_nothing(files)) bare_ = std::make_shared<const TerrainData>(read_ground(files));
}

std::shared_ptr<Ground> Grounds::of(const MapSpec& spec) {
  return ground_of(bare_ ? TerrainForMap{bare_, nullptr} : terrains_.of(spec));
}

std::shared_ptr<Ground> Grounds::before_views(const MapSpec& spec) {
  return ground_of({bare_ ? bare_ : terrains_.before_views(spec), nullptr});
}

std::shared_ptr<Ground> Grounds::ground_of(TerrainForMap made) {
  const auto terrain = made.terrain;
  const std::lock_guard lock(mutex_);
  if (const auto known = kept_.find(terrain.get()); known != kept_.end()) return known->second;
  const auto ground = std::make_shared<Ground>(std::move(made));
  ground->overlays = read_overlays(files_.overlays, *terrain);
  if (!files_.labels.path.empty()) ground->names = read_overlays({&files_.labels, 1}, *terrain);
  const auto& larger = terrain->larger_cells;
  const bool is_of_one_eye = larger && !larger->parts.empty();
  if (!is_of_one_eye) kept_.emplace(terrain.get(), ground);
  return ground;
}

} // namespace orograph
