// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/view_in_frame.hpp"

#include "view/phigs_view.hpp"

#include <algorithm>

namespace orograph {
namespace {

// Farther than any terrain; 14 digits are left for what is a metre.
constexpr double kOutOfTheWay_m = 1e8;

// A direction of one frame in another. What is a megametre long loses nothing that counts.
Vec3 in_frame(const LocalFrame& from, const LocalFrame& to, Vec3 direction) {
  constexpr double kLength_m = 1e6;
  const auto moved = [&](Vec3 place_m) {
    const GeoPoint at = from.to_geodetic(place_m);
    return to.to_frame(at.lon_deg, at.lat_deg, at.h_m);
  };
  return (1 / kLength_m) * (moved(kLength_m * direction) - moved({}));
}

} // namespace

PhigsView phigs_view(const ViewFile& file, const MapFrame& map, double exaggeration) {
  PhigsView view;
  view.projection = file.projection;
  view.vrp_m = map.to_ground_m(file.vrp_map);
  view.vrp_m.z *= exaggeration;
  view.vpn = file.vpn;
  view.vup = file.vup;
  view.prp_m = file.prp_m;
  view.window_m = file.window_m;
  // Beyond that they are out of the way as well, and their own numbers might be too large.
  view.back_m = std::max(file.back_m.value_or(-kOutOfTheWay_m), -kOutOfTheWay_m);
  const bool perspective = file.projection == PhigsProjection::perspective;
  const double eye_n = file.prp_m.z;
  const double stand_in = perspective ? eye_n - 1e-6 * std::min(1.0, eye_n) : kOutOfTheWay_m;
  view.front_m = std::min(file.front_m.value_or(stand_in), stand_in);
  return view;
}

std::vector<HalfSpace> between_planes(const ViewFile& file, const MapFrame& map,
                                      double exaggeration) {
  const PhigsView view = phigs_view(file, map, exaggeration);
  const Vec3 n = (1 / length(view.vpn)) * view.vpn;
  // n . (P - VRP) for a point P with exaggerated height, of its true height.
  const Vec3 normal{n.x, n.y, n.z * exaggeration};
  const double at_vrp = dot(n, view.vrp_m);
  std::vector<HalfSpace> spaces;
  if (file.front_m) spaces.push_back({normal, *file.front_m + at_vrp});
  if (file.back_m) spaces.push_back({-1.0 * normal, -(*file.back_m + at_vrp)});
  return spaces;
}

ViewFile view_file_of(const View& view, const MapFrame& map) {
  const PhigsView phigs = phigs_of(view);
  ViewFile file{phigs.projection, {}, phigs.vpn, phigs.vup,        phigs.prp_m,
                phigs.window_m,   {}, {},        view.exaggeration};
  file.vrp_map = map.to_map({phigs.vrp_m.x, phigs.vrp_m.y, phigs.vrp_m.z / view.exaggeration});
  if (map.earth && view.is_perspective()) {
    const LocalFrame& frame = map.earth->local;
    const GeoPoint eye =
        frame.to_geodetic({view.depth_origin_m.x, view.depth_origin_m.y, view.eye_z_m});
    const LocalFrame below(eye.lon_deg, eye.lat_deg, frame.ellipsoid());
    file.vpn = in_frame(frame, below, file.vpn);
    file.vup = in_frame(frame, below, file.vup);
  }
  return file;
}

} // namespace orograph
