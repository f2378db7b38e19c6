// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/read_ground.hpp"

#include "dem/read/read_terrain.hpp"

namespace orograph {

bool is_scene(const std::string& input) {
  return input.ends_with(".toml") || input.ends_with(".TOML");
}

TerrainData read_ground(const RenderSettings& settings) {
  if (settings.inputs.size() != 1 || !is_scene(settings.inputs.front()))
    return read_terrain(settings.inputs, settings.reading);
  TerrainData bare;
  bare.surface = Tin{};
  bare.map.crs_name = "none";
  bare.source = settings.inputs.front();
  bare.paths = settings.inputs;
  return bare;
}

} // namespace orograph
