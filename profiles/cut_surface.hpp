// SPDX-License-Identifier: GPL-3.0-or-later
// The cut of any kind of surface.
#pragma once

#include "dem/surface.hpp"
#include "profiles/cut_grid.hpp"
#include "profiles/cut_mesh.hpp"

#include <span>
#include <variant>
#include <vector>

namespace orograph {

/// The cutter of the surface's kind, with the promises of all.
class SurfaceCutter {
public:
  /// `border` is that of `border_edges`; only a grid on the ellipsoid needs it.
  /// REQUIRES that `surface` and `level` outlive the cutter.
  SurfaceCutter(const Surface& surface, const View& view, const TriangleSet& level,
                const std::vector<BorderEdge>& border)
      : cutter_(cutter_of(surface, view, level, border)) {}

  void cut(double depth_m, Profile& out) const { cut(depth_m, kAllOfProfile, out); }
  /// At least the parts of the profile in `ranges`, as GridCutter has them.
  void cut(double depth_m, std::span<const URange> ranges, Profile& out) const {
    std::visit([&](const auto& cutter) { cutter.cut(depth_m, ranges, out); }, cutter_);
  }

  /// Depths between which the surface lies.
  double nearest_m() const {
    return std::visit([](const auto& cutter) { return cutter.nearest_m(); }, cutter_);
  }
  double farthest_m() const {
    return std::visit([](const auto& cutter) { return cutter.farthest_m(); }, cutter_);
  }

private:
  using Cutter = std::variant<GridCutter, EarthGridCutter, TinCutter>;

  static Cutter cutter_of(const Surface& surface, const View& view, const TriangleSet& level,
                          const std::vector<BorderEdge>& border) {
    if (const Tin* tin = std::get_if<Tin>(&surface)) return TinCutter(*tin, view, level);
    const Grid& grid = std::get<Grid>(surface);
    if (grid.is_on_earth()) return EarthGridCutter(grid, view, level, border);
    return GridCutter(grid, view, level);
  }

  Cutter cutter_;
};

} // namespace orograph
