// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/placed_solids.hpp"

#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"
#include "placing/places.hpp"
#include "placing/view_in_frame.hpp"
#include "solids/solids_in_view.hpp"
#include "solids/standing_solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace orograph {
namespace {

NamedPlace named(const ScenePlace& place, const std::string& path) {
  NamedPlace out{place.lonlat ? "lonlat" : "at",
                 {place.x, place.y},
                 place.lonlat,
                 fmt::format("{}, line {}: ", path, place.line)};
  out.place.z = place.height;
  return out;
}

// East, north and up at a place on the ellipsoid, in the ground frame.
PlaceFrame frame_at(const EarthFrame& earth, Vec3 at_m) {
  const GeoPoint here = earth.local.to_geodetic(at_m);
  const LocalFrame own(here.lon_deg, here.lat_deg, earth.local.ellipsoid());
  constexpr double kFar_m = 1e6; // so that the rounding of places counts for little
  const auto moved = [&](Vec3 own_m) {
    const GeoPoint point = own.to_geodetic(own_m);
    return earth.local.to_frame(point.lon_deg, point.lat_deg, point.h_m);
  };
  const Vec3 origin = moved({});
  const auto along = [&](Vec3 axis) { return (1 / kFar_m) * (moved(kFar_m * axis) - origin); };
  return {at_m, along({1, 0, 0}), along({0, 1, 0}), earth.exaggeration * along({0, 0, 1})};
}

PlaceFrame frame_of(const ScenePlace& place, const SceneFile& scene, const TerrainData& terrain) {
  NamedPlace at = named(place, scene.path);
  if (!has_ground(terrain.surface) && !at.place.z) at.place.z = 0;
  const Vec3 at_m = place_in_ground_frame(at, terrain, 0);
  return terrain.map.earth ? frame_at(*terrain.map.earth, at_m) : PlaceFrame{at_m};
}

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

std::vector<StandingSolid> stand_solids(const SceneFile& scene, const TerrainData& terrain) {
  std::vector<PlaceFrame> frames;
  for (const ScenePlace& place : scene.places) frames.push_back(frame_of(place, scene, terrain));
  std::vector<StandingSolid> out;
  out.reserve(scene.instances.size());
  for (const SolidInstance& instance : scene.instances)
    out.push_back(stand_at(frames[instance.place], instance, scene));
  return out;
}

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
