// SPDX-License-Identifier: GPL-3.0-or-later
// What maps are drawn of, from files: the terrain, with what holds for all views of it.
#pragma once

#include "dem/overlay.hpp"
#include "dem/read/overlay_input.hpp"
#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"
#include "placing/terrain_for_views.hpp"
#include "placing/terrains_for_maps.hpp"
#include "solids/scene_file.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// The files, and how they are read.
struct GroundFiles {
  std::vector<std::string> inputs; ///< one at least; several are joined
  ReadOptions reading;
  std::shared_ptr<const SceneFile> solids; ///< null: none
  std::vector<OverlayInput> overlays;
  OverlayInput labels; ///< places with names; an empty path: none
};

/// Whether an input is a scene, by its extension; it is drawn alone.
bool is_scene(const std::string& input);
/// Whether it is the only one.
bool stands_on_nothing(const GroundFiles& files);

/// The terrain of these files; of a scene alone one without ground (`has_ground`). Throws Error as
/// `read_terrain` does.
TerrainData read_ground(const GroundFiles& files);

/// The terrain, and what lies on it.
struct Ground {
  explicit Ground(TerrainForMap of) : terrain(std::move(of.terrain), std::move(of.facts)) {}

  TerrainForViews terrain;
  std::vector<Overlay> overlays, names;
};

/// Nearly always all views have one. Of a large raster each has the cells that are read for it
/// alone, so that it draws the same; what is read for one eye is forgotten with its view. Several
/// threads may ask at a time.
class Grounds {
public:
  /// REQUIRES that `files` outlive this.
  explicit Grounds(const GroundFiles& files);

  /// As `TerrainsForMaps` does; throws its Errors.
  std::shared_ptr<Ground> of(const MapSpec& spec);
  std::shared_ptr<Ground> before_views(const MapSpec& spec);

private:
  std::shared_ptr<Ground> ground_of(TerrainForMap made);

  const GroundFiles& files_;
  std::shared_ptr<const TerrainData> bare_; ///< of a scene that stands on nothing
  TerrainsForMaps terrains_;
  std::mutex mutex_;
  std::map<const TerrainData*, std::shared_ptr<Ground>> kept_;
};

} // namespace orograph
