// SPDX-License-Identifier: GPL-3.0-or-later
// The ground with less detail where the page shows less: heights in the profile frame of a view, as
// means over about as much of the page everywhere.
#pragma once

#include "dem/surface.hpp"
#include "geometry/box.hpp"
#include "placing/placed_view.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace orograph {

/// The smoothed ground at a place.
struct SmoothPlace {
  double z_m;          ///< in the profile frame
  double per_u, per_v; ///< by how much that changes a metre
  double up_u, up_v;   ///< where the true height rises, and by how much, a metre: 1 is 45 degrees
  double node_m;       ///< distance of the means that it is made of
  double slope() const { return std::hypot(up_u, up_v); }
};

/// Means over squares of the ground that are 2^n nodes wide, and between them quadratic splines
/// (whose slope has no jumps), of the n for which a square is about `over_mm` wide on the page.
/// Nodes are as far apart as the terrain's cells, or as 4 million of them allow.
class SmoothGround {
public:
  /// REQUIRES that the view outlives it. Cost: one sample of the ground a node.
  SmoothGround(const Surface& surface, const PlacedView& placed, double over_mm);

  /// None where there is no ground, or where the page has no place for it.
  std::optional<SmoothPlace> at(double u_m, double v_m) const;

  /// In the profile frame's u and v: what was sampled.
  const Box2& bounds_m() const { return bounds_m_; }
  double node_m() const { return node_m_; }

private:
  struct Level {
    std::size_t columns, rows;
    std::vector<float> z_m; ///< NaN: no ground
  };
  struct Spline {
    bool is_there = false;
    double z = 0, per_u = 0, per_v = 0;
  };
  void sample(const Surface& surface);
  void add_levels();
  std::optional<double> nearest_node_m(double u_m, double v_m) const;
  Spline spline_at(std::size_t level, double u_m, double v_m) const;

  const PlacedView& placed_;
  double over_mm_;
  Box2 bounds_m_;
  double node_m_ = 0;
  std::vector<Level> levels_;
};

} // namespace orograph
