// SPDX-License-Identifier: GPL-3.0-or-later
// Terrains in cells as small as maps need them, and no smaller.
#pragma once

#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"
#include "placing/map_spec.hpp"
#include "placing/terrain_facts.hpp"
#include "solids/scene_file.hpp"

#include <compare>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace orograph {

/// What is asked of a raster that is large.
struct LevelAsked {
  int least_cells = 0; ///< along the shorter side; 0: all
  bool with_nested = false;

  auto operator<=>(const LevelAsked&) const = default;
};

/// A terrain, and what was found of it to know which cells it needs: null where nobody asked, and
/// in degrees, where each view has a frame, and facts, of its own.
struct TerrainForMap {
  std::shared_ptr<const TerrainData> terrain;
  std::shared_ptr<const TerrainFacts> facts;
};

/// The terrain of some files, read as often as maps of it need other cells. Several threads may use
/// it at a time.
class TerrainsForMaps {
public:
  /// REQUIRES that `solids`, which may be null, outlives this.
  TerrainsForMaps(std::vector<std::string> paths, ReadOptions options, const SceneFile* solids);

  /// For the map; of a raster of more than 16 million heights larger cells: not larger than those
  /// that `choose_level` draws, which are half as large mostly. Where an eye stands over it, the
  /// raster's own cells as well in parts, for this map alone: those that the page asks for; the
  /// same with nested cells where it is to be within a bound. The whole raster where `spec` draws
  /// its own surface, where the planes of a file's view cut it, where it is in degrees and lines
  /// are draped over patches, and where it is checked against the file. Throws the Errors of
  /// `read_terrain`, and of placing the view; `progress` as of the first.
  TerrainForMap of(const MapSpec& spec, const std::function<void(double)>& progress = {});

  /// The same before it is known from where the terrain is looked at: as if the page shows it whole
  /// as large as it can.
  std::shared_ptr<const TerrainData> before_views(const MapSpec& spec);

private:
  std::shared_ptr<const TerrainData> read(LevelAsked asked,
                                          const std::function<void(double)>& progress);

  const std::vector<std::string> paths_;
  const ReadOptions options_;
  const SceneFile* const solids_;
  std::mutex mutex_;
  std::map<LevelAsked, std::shared_ptr<const TerrainData>> by_level_;
  std::shared_ptr<const TerrainData> not_large_; ///< once it is known: serves all maps
};

} // namespace orograph
