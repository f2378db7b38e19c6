// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/draw_level.hpp"

#include "dem/surface.hpp"
#include "geometry/error.hpp"
#include "map/check.hpp"
#include "map/error_budget.hpp"

#include <fmt/format.h>

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

void check_not_empty(const Map& map, const ViewSpec& view, bool of_scene) {
  if (map.facts.counts.strokes > 0) return;
  const char* const right =
      view.file             ? "turn the view towards it, or widen its window"
      : view.altitude_range ? "widen `altitude_range`, or leave it out"
                            : "turn the view towards it, widen `field_of_view`, or raise an eye "
                              "that faces a slope";
  throw Error(fmt::format("nothing of the {} is on the page", of_scene ? "scene" : "terrain"),
              right);
}

} // namespace orograph
