// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_view.hpp"

#include "view/place_phigs_view.hpp"

#include <algorithm>

namespace orograph {
namespace {

// Farther than any terrain; 14 digits are left for what is a metre.
constexpr double kOutOfTheWay_m = 1e8;

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
  return file;
}

} // namespace orograph
