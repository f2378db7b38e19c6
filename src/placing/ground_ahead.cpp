// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/ground_ahead.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/cut_surface.hpp"
#include "view/sectors.hpp"

#include <cmath>
#include <limits>
#include <span>

namespace orograph {
namespace {

// The same eye, with the column's plane as its profile of depth 0, u leading ahead.
View along_column(const View& view, const EarthDrop& drop, double x) {
  View out = view;
  out.right = (1 / std::hypot(1, x)) * (view.forward + x * view.right);
  out.forward = {-out.right.y, out.right.x};
  out.drop = drop_in_frame(drop, out.forward);
  return out;
}

GroundAhead ground_in_column(const View& view, const EarthDrop& drop, const CutSurface& of,
                             double x) {
  const SurfaceCutter cutter(of.surface, along_column(view, drop, x), of.level, of.for_cutters,
                             of.box_m);
  const URange ahead{0, std::numeric_limits<double>::infinity()};
  Profile profile;
  cutter.cut(0, std::span(&ahead, 1), profile);
  GroundAhead out{.x = x, .v_m = {}, .z_m = {}};
  const double depth_share = 1 / std::hypot(1, x);
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const double v_m = depth_share * profile.u_m[i];
    const bool is_ground =
        profile.after[i] != Span::gap || (i > 0 && profile.after[i - 1] != Span::gap);
    if (!is_ground || v_m < view.near_m) continue;
    out.v_m.push_back(v_m);
    out.z_m.push_back(profile.z_m[i]);
  }
  return out;
}

} // namespace

std::ptrdiff_t GroundAhead::skyline(const View& view, double above_m) const {
  std::ptrdiff_t at = -1;
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < v_m.size(); ++i)
    if (const double there = (z_m[i] - view.eye_z_m - above_m) / v_m[i]; there > greatest) {
      greatest = there;
      at = static_cast<std::ptrdiff_t>(i);
    }
  return at;
}

std::vector<GroundAhead> ground_ahead(const View& view, const EarthDrop& drop, const CutSurface& of,
                                      int columns) {
  std::vector<double> abscissae;
  const Box2& window = view.window;
  for (int i = 0; i < columns; ++i) {
    const double share = static_cast<double>(i) / (columns - 1);
    const double across = (1 - share) * window.low.x + share * window.high.x; // its ends exactly
    const Vec3 ray = ray_of_picture(view, {across, window.centre().y});
    if (ray.z > 0) abscissae.push_back(ray.x / ray.z);
  }
  std::vector<GroundAhead> out(abscissae.size());
  on_all_cores(out.size(),
               [&](std::size_t i) { out[i] = ground_in_column(view, drop, of, abscissae[i]); });
  return out;
}

} // namespace orograph
