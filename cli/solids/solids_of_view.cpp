// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/solids/solids_of_view.hpp"

#include "cli/scene_view.hpp"
#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "solids/holds_eye.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace orograph {
namespace {

std::string place_of(const StandingSolid& solid, const SceneFile& scene) {
  const ScenePlace& place = scene.places[solid.place];
  return fmt::format("{}, line {}: part '{}'", scene.path, place.line, place.part);
}

// Wholly beyond one of the planes, or wholly within all.
struct Cut {
  bool is_away = false, is_whole = true;
};

Cut cut_of(const StandingSolid& solid, const std::vector<HalfSpace>& within) {
  Cut cut;
  for (const HalfSpace& space : within) {
    const auto any_on_side = [&](int side) {
      return std::any_of(solid.vertices_m.begin(), solid.vertices_m.end(),
                         [&](const Vec3& vertex) { return side_of(space, vertex) == side; });
    };
    cut.is_whole = cut.is_whole && !any_on_side(1);
    cut.is_away = cut.is_away || !any_on_side(-1);
  }
  return cut;
}

} // namespace

void leave_out_cut(std::vector<StandingSolid>& standing, const SceneFile& scene,
                   const ViewFile& view, const MapFrame& map, double exaggeration) {
  const std::vector<HalfSpace> within = between_planes(view, map, exaggeration);
  std::erase_if(standing, [&](const StandingSolid& solid) {
    const Cut cut = cut_of(solid, within);
    if (!cut.is_away && !cut.is_whole)
      throw Error(place_of(solid, scene) + " is cut by the view's front or back plane",
                  "move the plane, or the part");
    return cut.is_away;
  });
}

void check_eye_outside(const std::vector<StandingSolid>& standing, const SceneFile& scene,
                       const View& view) {
  if (!view.is_perspective()) return;
  std::vector<std::uint8_t> holds(standing.size());
  on_all_cores(standing.size(),
               [&](std::size_t i) { holds[i] = holds_eye(standing[i], view) ? 1 : 0; });
  const auto first = std::find(holds.begin(), holds.end(), 1);
  if (first == holds.end()) return;
  throw Error("the eye is inside of a solid: " +
                  place_of(standing[static_cast<std::size_t>(first - holds.begin())], scene),
              "move the eye, or the part");
}

} // namespace orograph
