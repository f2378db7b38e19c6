// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/solids/stand_solids.hpp"

#include "cli/named_place.hpp"
#include "solids/stand.hpp"

#include <fmt/format.h>

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

PlaceFrame frame_of(const ScenePlace& place, const SceneFile& scene, const Terrain& terrain) {
  NamedPlace at = named(place, scene.path);
  if (!has_ground(terrain.surface) && !at.place.z) at.place.z = 0;
  const Vec3 at_m = place_in_ground_frame(at, terrain, 0);
  return terrain.map.earth ? frame_at(*terrain.map.earth, at_m) : PlaceFrame{at_m};
}

} // namespace

std::vector<StandingSolid> stand_solids(const SceneFile& scene, const Terrain& terrain) {
  std::vector<PlaceFrame> frames;
  for (const ScenePlace& place : scene.places) frames.push_back(frame_of(place, scene, terrain));
  std::vector<StandingSolid> out;
  out.reserve(scene.instances.size());
  for (const SolidInstance& instance : scene.instances)
    out.push_back(stand_at(frames[instance.place], instance, scene));
  return out;
}

} // namespace orograph
