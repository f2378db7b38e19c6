// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/place_eye.hpp"

#include "cli/named_place.hpp"
#include "dem/read/lonlat.hpp"

namespace orograph {
namespace {

std::optional<NamedPlace> named(const std::string& option, const std::optional<GivenPlace>& map,
                                const std::optional<GivenPlace>& lonlat) {
  if (map) return NamedPlace{option, *map, false};
  if (lonlat) return NamedPlace{option + "-lonlat", *lonlat, true};
  return std::nullopt;
}

std::optional<NamedPlace> eye_of(const RenderSettings& settings) {
  return named("--eye", settings.eye_map, settings.eye_lonlat);
}
std::optional<NamedPlace> target_of(const RenderSettings& settings) {
  return named("--look-at", settings.look_at_map, settings.look_at_lonlat);
}

LookDirection direction(const RenderSettings& settings, const MapFrame& map, Vec3 eye_m) {
  if (map.earth) return {*settings.look_azimuth, settings.pitch}; // the frame's north is true
  const Vec3 eye = map.to_map(eye_m);
  const auto azimuth = map_azimuth(map.crs_wkt, {eye.x, eye.y}, *settings.look_azimuth);
  return {azimuth.value_or(*settings.look_azimuth), settings.pitch};
}

} // namespace

void place_eye(ViewRequest& request, const RenderSettings& settings, const Terrain& terrain) {
  if (const auto eye = eye_of(settings)) {
    const double above_m = settings.eye_height_m.value_or(kEyeHeight_m) / request.exaggeration;
    request.eye_m = place_in_ground_frame(*eye, terrain, above_m);
    if (settings.look_azimuth) request.look = direction(settings, terrain.map, *request.eye_m);
  }
  if (const auto target = target_of(settings))
    request.look_at_m = place_in_ground_frame(*target, terrain, 0);
}

std::optional<Vec2> given_place(const RenderSettings& settings, const Terrain& terrain) {
  if (const auto eye = eye_of(settings)) return place_on_map(*eye, terrain);
  if (const auto target = target_of(settings)) return place_on_map(*target, terrain);
  return std::nullopt;
}

} // namespace orograph
