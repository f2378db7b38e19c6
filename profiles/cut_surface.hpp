// SPDX-License-Identifier: GPL-3.0-or-later
// The cut of any kind of surface.
#pragma once

#include "dem/surface.hpp"
#include "profiles/cut_earth_grid.hpp"
#include "profiles/cut_grid.hpp"
#include "profiles/cut_mesh.hpp"
#include "profiles/cutter_facts.hpp"
#include "profiles/heights_along.hpp"
#include "profiles/profile.hpp"

#include <span>
#include <utility>
#include <variant>

namespace orograph {

/// The cutter of the surface's kind, with the promises of all.
class SurfaceCutter {
public:
  /// A grid on the ellipsoid needs its `border_places`, a TIN is spared to find its own; of the
  /// former `box`, that of all vertices, makes parts of profiles cheap. REQUIRES that `surface` and
  /// `level` outlive the cutter.
  SurfaceCutter(const Surface& surface, const View& view, const TriangleSet& level,
                CutterFacts facts, const Box3* box = nullptr)
      : surface_(surface), view_(view), level_(level),
        cutter_(cutter_of(surface, view, level, std::move(facts), box)) {}

  void cut(double depth_m, Profile& out) const { cut(depth_m, kAllOfProfile, out); }
  /// At least the parts of the profile in `ranges`, as GridCutter has them.
  void cut(double depth_m, std::span<const URange> ranges, Profile& out) const {
    std::visit([&](const auto& cutter) { cutter.cut(depth_m, ranges, out); }, cutter_);
  }

  /// The ground's heights at places along a profile: a tenth of the cost of cutting it where they
  /// are farther apart than cells, and the surface is a grid that has_heights_along.
  void heights(double depth_m, const PlacesAlong& at, HeightsAlong& out) const {
    const AskedProfile asked{depth_m, at, &out};
    heights(std::span(&asked, 1));
  }
  /// The same along several at once.
  void heights(std::span<const AskedProfile> profiles) const {
    const Grid* const grid = std::get_if<Grid>(&surface_);
    if (grid && has_heights_along(*grid)) {
      heights_along(*grid, view_, level_, profiles);
      return;
    }
    thread_local Profile profile;
    for (const AskedProfile& asked : profiles) {
      const URange range{asked.at[0], asked.at[asked.at.count - 1]};
      cut(asked.depth_m, std::span(&range, 1), profile);
      heights_along(profile, asked.at, *asked.heights);
    }
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
                          CutterFacts facts, const Box3* box) {
    if (const Tin* tin = std::get_if<Tin>(&surface))
      return TinCutter(*tin, view, level, std::move(facts.of_tin), std::move(facts.tin_index),
                       facts.both_sides);
    const Grid& grid = std::get<Grid>(surface);
    if (grid.is_on_earth())
      return EarthGridCutter(grid, view, level, std::move(facts.of_earth_grid), box);
    return GridCutter(grid, view, level);
  }

  const Surface& surface_;
  View view_;
  const TriangleSet& level_;
  Cutter cutter_;
};

} // namespace orograph
