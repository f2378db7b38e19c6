// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/solids/stand_solids.hpp"

#include "cli/named_place.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <fmt/format.h>

#include <cmath>

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

// A place's axes, as columns, and where it is.
struct Stand {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Vec3 at_m;
};

// East, north and up at a place on the ellipsoid, in the ground frame.
Eigen::Matrix3d axes_at(const EarthFrame& earth, Vec3 at_m) {
  const GeoPoint here = earth.local.to_geodetic(at_m);
  const LocalFrame own(here.lon_deg, here.lat_deg, earth.local.ellipsoid());
  constexpr double kFar_m = 1e6; // so that the rounding of places counts for little
  const auto moved = [&](Vec3 own_m) {
    const GeoPoint point = own.to_geodetic(own_m);
    return earth.local.to_frame(point.lon_deg, point.lat_deg, point.h_m);
  };
  Eigen::Matrix3d axes;
  const Vec3 origin = moved({});
  int column = 0;
  for (const Vec3 axis : {Vec3{kFar_m, 0, 0}, Vec3{0, kFar_m, 0}, Vec3{0, 0, kFar_m}}) {
    const Vec3 along = (1 / kFar_m) * (moved(axis) - origin);
    axes.col(column++) = Eigen::Vector3d(along.x, along.y, along.z);
  }
  axes.col(2) *= earth.exaggeration;
  return axes;
}

Stand stand_at(const ScenePlace& place, const SceneFile& scene, const Terrain& terrain) {
  Stand stand;
  NamedPlace at = named(place, scene.path);
  if (!has_ground(terrain.surface) && !at.place.z) at.place.z = 0;
  stand.at_m = place_in_ground_frame(at, terrain, 0);
  if (terrain.map.earth) stand.axes = axes_at(*terrain.map.earth, stand.at_m);
  return stand;
}

} // namespace

std::vector<StandingSolid> stand_solids(const SceneFile& scene, const Terrain& terrain) {
  std::vector<Stand> stands;
  for (const ScenePlace& place : scene.places) stands.push_back(stand_at(place, scene, terrain));
  std::vector<StandingSolid> out;
  out.reserve(scene.instances.size());
  for (const SolidInstance& instance : scene.instances) {
    const Stand& stand = stands[instance.place];
    const Solid& solid = scene.solids[instance.solid];
    const Eigen::Matrix3d linear = stand.axes * instance.to_place.topLeftCorner<3, 3>();
    const Eigen::Vector3d moved = stand.axes * instance.to_place.topRightCorner<3, 1>();
    StandingSolid standing{&solid, {}, linear.determinant() < 0, instance.place};
    standing.vertices_m.reserve(solid.vertices_m.size());
    for (const Vec3& v : solid.vertices_m) {
      const Eigen::Vector3d at = linear * Eigen::Vector3d(v.x, v.y, v.z) + moved;
      standing.vertices_m.push_back(stand.at_m + Vec3{at.x(), at.y(), at.z()});
    }
    out.push_back(std::move(standing));
  }
  return out;
}

} // namespace orograph
