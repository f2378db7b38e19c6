// SPDX-License-Identifier: GPL-3.0-or-later
// The size of cells that a page shows (docs/decisions/0045-level-of-detail.md).
#pragma once

#include "dem/levels/departure.hpp"
#include "dem/levels/level_of_detail.hpp"
#include "dem/levels/summits.hpp"
#include "placing/map_spec.hpp"
#include "placing/terrain_facts.hpp"
#include "placing/terrain_of_view.hpp"
#include "solids/scene_file.hpp"

#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace orograph {

/// A level that views of any place may show, and how far it is from the file's surface.
struct MadeLevel {
  double step = 1; ///< of the file's cells to one
  std::shared_ptr<const TerrainLevel> level;
  Departure departure;
  std::vector<Summit> summits;
};

/// The level that was made last, for other views of the same terrain, which mostly want the same:
/// it is a third of what drawing a view of mountains takes. Several threads may use it at a time.
class LastLevel {
public:
  /// None where the last one isn't of this step.
  std::shared_ptr<const MadeLevel> of_step(double step) const {
    const std::lock_guard lock(mutex_);
    return made_ && made_->step == step ? made_ : nullptr;
  }
  void keep(std::shared_ptr<const MadeLevel> made) {
    const std::lock_guard lock(mutex_);
    made_ = std::move(made);
  }

private:
  mutable std::mutex mutex_;
  std::shared_ptr<const MadeLevel> made_;
};

/// Where the page is to show the terrain in cells of `spec.style.detail` and the file's are half or
/// twice as large, `terrain` becomes a level of itself: generalised, or refined up to a million
/// vertices; where an eye stands over it, a TIN of patches of both. None: it stays as it is; so do
/// TINs and what the view's planes cut. `of_whole` as in `placed_view`. `last` may have the level,
/// and keeps it: REQUIRES that it is always of the same whole terrain. Cost: some 10 ns a height of
/// the file, 60 ns one of what is refined, and 0.5 us a vertex of patches.
std::optional<LevelOfDetail> choose_level(TerrainOfView& terrain, const MapSpec& spec,
                                          const SceneFile* solids, const TerrainFacts* of_whole,
                                          LastLevel* last = nullptr);

} // namespace orograph
