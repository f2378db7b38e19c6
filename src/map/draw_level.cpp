// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/draw_level.hpp"

#include "dem/surface.hpp"
#include "map/check.hpp"
#include "map/error_budget.hpp"

#include <utility>

namespace orograph {

Map draw_level(const TerrainOfView& terrain, const PlacedView& placed, const MapSpec& spec,
               const std::optional<LevelOfDetail>& level,
               const std::function<void(double)>& progress, Instruments instruments) {
  const double within_mm = level_of_detail_mm(*terrain, placed, level);
  std::optional<Check> of_file;
  if (spec.check_of_file > 0 && has_ground(terrain->surface)) {
    of_file.emplace(terrain.of_file(), placed, spec.style.visibility_tolerance_mm + 2 * within_mm,
                    spec.check_of_file, false);
    of_file->ask_drawn_alone();
    instruments.observers.push_back(&*of_file);
  }
  Map map = draw_map(*terrain, placed, spec, progress, std::move(instruments));
  map.facts.level = level;
  if (of_file) map.facts.check_of_file = CheckOfFile{within_mm, of_file->counts()};
  return map;
}

} // namespace orograph
