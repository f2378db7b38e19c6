// SPDX-License-Identifier: GPL-3.0-or-later
// Which visible silhouettes are folds of a slope, and how much ink they would be.
#pragma once

#include "hidden_lines/line_pictures.hpp"
#include "placing/placed_view.hpp"
#include "profiles/ground_behind.hpp"

#include <optional>
#include <vector>

namespace orograph {

/// A part of a silhouette is a fold if the ground behind its middle comes up again within a share
/// of the depth (`Style::silhouette_jump`); of one of the underside, if it comes down again. In a
/// parallel view, which has no eye to be far from, the share is of the sector's own extent in
/// depth.
class Folds {
public:
  /// Nothing is a fold with a share of 0. REQUIRES that all outlive this.
  Folds(const Surface& surface, const PlacedView& placed, const Sector& sector, double share);

  /// Of a part of a line, whose middle is given. Cost: little more than that of `GroundBehind`.
  bool is_fold(const EdgeLine& line, ProfilePoint middle) const;
  /// Those of `parts` that are. On all cores.
  std::vector<LinePart> among(const LinePictures& lines, const std::vector<LinePart>& parts) const;

  /// Within which depth ground behind a point makes a fold of it.
  double reach_m(double depth_m) const {
    return share_ * (sector_.view.is_perspective() ? depth_m : parallel_depth_m_);
  }

  /// Length of a part of a line in the frame.
  double length_mm(const ProfileLine& whole, const LinePart& part) const;
  /// Of each of these parts, on all cores.
  std::vector<double> lengths_mm(const LinePictures& lines,
                                 const std::vector<LinePart>& parts) const;
  /// The same between two points of the visibility plane, if both are well inside: otherwise NaN.
  double length_if_inside_mm(Vec2 a, Vec2 b) const;

private:
  const PlacedView& placed_;
  const Sector& sector_;
  std::optional<GroundBehind> ground_; ///< where there may be folds
  double share_, parallel_depth_m_;
};

} // namespace orograph
