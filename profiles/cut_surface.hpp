// SPDX-License-Identifier: GPL-3.0-or-later
// The cut of either kind of surface.
#pragma once

#include "dem/surface.hpp"
#include "profiles/cut_grid.hpp"
#include "profiles/cut_tin.hpp"

#include <variant>

namespace orograph {

/// A `GridCutter` or a `TinCutter`, with the promises of both.
class SurfaceCutter {
public:
  /// REQUIRES that `surface` and `level` outlive the cutter.
  SurfaceCutter(const Surface& surface, const View& view, const TriangleSet& level)
      : cutter_(std::holds_alternative<Grid>(surface)
                    ? Cutter(std::in_place_type<GridCutter>, std::get<Grid>(surface), view, level)
                    : Cutter(std::in_place_type<TinCutter>, std::get<Tin>(surface), view, level)) {}

  void cut(double depth_m, Profile& out) const {
    std::visit([&](const auto& cutter) { cutter.cut(depth_m, out); }, cutter_);
  }

  /// Depths between which the surface lies.
  double nearest_m() const {
    return std::visit([](const auto& cutter) { return cutter.nearest_m(); }, cutter_);
  }
  double farthest_m() const {
    return std::visit([](const auto& cutter) { return cutter.farthest_m(); }, cutter_);
  }

private:
  using Cutter = std::variant<GridCutter, TinCutter>;
  Cutter cutter_;
};

} // namespace orograph
