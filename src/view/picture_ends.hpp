// SPDX-License-Identifier: GPL-3.0-or-later
// How far a terrain's picture reaches to the right, left, up and down, by looking at few of its
// points.
#pragma once

#include "view/place_view.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// A picture coordinate of a point: sign * (x or y); infinite where it lies nearer than `nearest_m`
/// or has no picture.
struct PictureCoordinate {
  const View& view;
  double nearest_m;
  int row; ///< 0: x
  double sign;

  double of(ProfilePoint p) const;
  /// Of a point in the ground frame.
  double operator()(Vec3 ground) const { return of(to_profile_frame(view, ground)); }
  /// No less than the coordinate is anywhere in a box of the ground frame; but no more than `found`
  /// has to be told, if it is no more than that anywhere.
  double bound(const Box3& box, double found) const;

private:
  double bound_by_corners(const Box3& box) const;
  std::optional<double> bound_near(double value, const Box3& box) const;
};

/// Points of a terrain that tell much of how large its picture is.
struct PictureEnds {
  /// Those that bounded the picture when it was last measured: likely to be nearly those that bound
  /// it from another distance.
  std::array<std::optional<Vec3>, 4> points;
  /// Those of the outline that an eye which comes nearer has beside or behind it first.
  std::vector<Vec3> nearest;

  /// For a view in its direction, from wherever its eye will be.
  PictureEnds(const View& view, std::span<const OutlineEdge> outline);

  std::optional<Vec3>& of(const PictureCoordinate& coordinate) {
    return points[static_cast<std::size_t>(2 * coordinate.row + (coordinate.sign > 0))];
  }
};

/// The greatest over the terrain and what is on it; `ends` gets the point that has it.
double greatest(const TerrainShape& terrain, const PictureCoordinate& coordinate,
                PictureEnds& ends);

} // namespace orograph
