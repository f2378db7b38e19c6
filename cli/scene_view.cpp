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
  const double eye_n = file.prp_m.z;
  view.back_m =
      file.back_m.value_or(std::min(-kOutOfTheWay_m, file.front_m.value_or(0) - kOutOfTheWay_m));
  // In perspective just beyond the eye.
  view.front_m =
      file.front_m.value_or(file.projection == PhigsProjection::perspective
                                ? eye_n - 1e-9 * (eye_n - view.back_m)
                                : std::max(kOutOfTheWay_m, view.back_m + kOutOfTheWay_m));
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
