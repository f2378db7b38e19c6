// SPDX-License-Identifier: GPL-3.0-or-later
// The terrain that a sweep's views look at, with what holds for all views of it.
#pragma once

#include "cli/render_settings.hpp"
#include "dem/overlay.hpp"
#include "dem/terrain.hpp"
#include "placing/level_of_detail.hpp"
#include "placing/terrain_facts.hpp"
#include "placing/terrains_for_maps.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace orograph {

struct Ground {
  std::shared_ptr<const TerrainData> terrain;
  std::vector<Overlay> overlays, names;
  std::optional<TerrainFacts> facts; ///< in degrees each view has a frame, and facts, of its own
  LastLevel level;                   ///< that views show
};

/// Nearly always all views have one. Of a large raster each has the cells that `render` would read
/// for it, so that it draws the same; what is read for one eye is forgotten with its view. Several
/// threads may ask at a time.
class Grounds {
public:
  /// REQUIRES that the settings outlive this.
  explicit Grounds(const RenderSettings& settings);

  /// As `TerrainsForMaps` does; throws its Errors.
  std::shared_ptr<Ground> of(const MapSpec& spec);
  std::shared_ptr<Ground> before_views();

private:
  std::shared_ptr<Ground> ground_of(std::shared_ptr<const TerrainData> terrain);

  const RenderSettings& settings_;
  std::shared_ptr<const TerrainData> bare_; ///< of a scene that stands on nothing
  TerrainsForMaps terrains_;
  std::mutex mutex_;
  std::map<const TerrainData*, std::shared_ptr<Ground>> kept_;
};

} // namespace orograph
