// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/eye_summit.hpp"

#include "geometry/error.hpp"
#include "placing/highest_vertex.hpp"
#include "placing/places.hpp"

#include <fmt/format.h>

namespace orograph {
namespace {

NamedPlace eye_place(const ViewSpec& view) {
  return view.eye_map ? NamedPlace{"`eye_map`", *view.eye_map, false}
                      : NamedPlace{"`eye_lonlat`", *view.eye_lonlat, true};
}

} // namespace

std::optional<EyeMove> eye_move(const ViewSpec& view, const TerrainData& terrain) {
  if (!view.eye_summit_m || !view.has_eye()) return std::nullopt;
  const NamedPlace named = eye_place(view);
  const Vec2 place = place_on_map(named, terrain);
  const MapFrame& map = terrain.map;
  EyeMove out{place, place};
  const auto highest = highest_vertices(terrain, {&place, 1}, *view.eye_summit_m).front();
  if (has_ground(terrain.surface))
    if (const auto ground = ground_at(place, terrain))
      out.from_m = map.to_map(*ground).z * map.height_unit_m;
  if (!highest && !out.from_m)
    throw Error(fmt::format("{}: there is no ground within {} m to put the eye on", named.text(),
                            *view.eye_summit_m),
                "give a place on the terrain, or a greater `eye_summit_m`");
  if (highest && !(out.from_m >= highest->height_m)) {
    out.to_map = highest->map;
    out.distance_m = highest->distance_m;
    out.to_m = highest->height_m;
  } else {
    out.to_m = *out.from_m;
  }
  return out;
}

ViewSpec on_summit(const ViewSpec& view, const TerrainData& terrain) {
  const auto move = eye_move(view, terrain);
  ViewSpec out = view;
  out.eye_summit_m.reset();
  if (!move) return out;
  GivenPlace eye(move->to_map.x, move->to_map.y);
  if (const auto& z = view.eye_map ? view.eye_map->z : view.eye_lonlat->z) {
    if (!move->from_m)
      throw Error(eye_place(view).text() +
                      ": there is no ground there, so the eye's height above it isn't known",
                  "leave its height out, or `eye_summit_m`");
    eye.z = *z + (move->to_m - *move->from_m) / terrain.map.height_unit_m;
  }
  out.eye_map = eye;
  out.eye_lonlat.reset();
  return out;
}

} // namespace orograph
